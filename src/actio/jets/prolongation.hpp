// First jets of vector fields on Y (sections 6.2 and 9.1 of the thesis).
#pragma once

#include "actio/jets/jet.hpp"

namespace actio {

/// A point of Y: x, then y, in one column.
template <class S, int n, int N>
Matrix<S, n + 1 + N, 1> point_of(Jet<S, n, N> const& j) {
  Matrix<S, n + 1 + N, 1> point;
  point << j.x, j.y;
  return point;
}

/// The prolongation \f$j^1\xi\f$ of a vector field on Y that covers one on X:
/// \f$(\xi^\mu, \xi^a, D_\mu\xi^a - v^a{}_\nu\,D_\mu\xi^\nu)\f$ with
/// \f$D_\mu = \partial_\mu + v^b{}_\mu\,\partial/\partial y^b\f$.
///
/// \implements{eq_9_3}
/// @param xi  a callable from points (x, y) of Y, one column, to their velocities, over any scalar; its x
///            part does not depend on y
/// @return    a vector field on the jet bundle: a callable from coordinates to tangent vectors
template <int n, int N, class Xi>
auto prolonged(Xi const& xi) {
  return [xi]<class S, int D>(Matrix<S, D, 1> const& at) {
    auto const j = jet_at<n, N>(at);
    // xi along the jet: D_mu xi is its derivative in the direction (e_mu, v_mu) of Y.
    auto const point = point_of(j);
    auto const xi_along = [&]<class T>(Event<T, n> const& s) -> Matrix<T, n + 1 + N, 1> {
      Matrix<T, n + 1 + N, 1> moved = point.template cast<T>();
      moved.template head<n + 1>() += s;
      moved.template tail<N>() += j.v.template cast<T>() * s;
      return xi(moved);
    };
    auto const [value, D_xi] = derivative(xi_along, Event<S, n>(Event<S, n>::Zero()));
    Jet<S, n, N> lifted{value.template head<n + 1>(), value.template tail<N>(), {}};
    // [eq_9_3]
    lifted.v = D_xi.template bottomRows<N>() - j.v * D_xi.template topRows<n + 1>();
    // [eq_9_3]
    return coordinates(lifted);
  };
}

}  // namespace actio
