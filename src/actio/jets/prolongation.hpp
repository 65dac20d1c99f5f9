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

/// The prolongation \f$j^1\xi\f$ of a vector field on Y that covers one on X: \f$(\xi^\mu, \xi^a, D_\mu\xi^a - v^a{}_\nu\,D_\mu\xi^\nu)\f$ with
/// \f$D_\mu = \partial_\mu + v^b{}_\mu\,\partial/\partial y^b\f$.
///
/// \implements{eq_9_3}
/// @param xi  a callable from points (x, y) of Y, one column, to their velocities, over any scalar; its x part does not depend on y
/// @return    a vector field on the jet bundle: a callable from coordinates to tangent vectors
template <int n, int N, class Xi>
auto prolonged(Xi const& xi) {
  return [xi]<class S, int D>(Matrix<S, D, 1> const& at) {
    using T = Dual<S, n + 1>;
    auto const j = jet_at<n, N>(at);
    Matrix<T, n + 1 + N, 1> moved = point_of(j).template cast<T>();
    for (int mu = 0; mu <= n; ++mu) {
      moved[mu].part[mu] = S(1);
      for (int b = 0; b < N; ++b) moved[n + 1 + b].part[mu] = j.v(b, mu);
    }
    Matrix<T, n + 1 + N, 1> const rate = xi(moved);
    Jet<S, n, N> lifted;
    for (int mu = 0; mu <= n; ++mu) lifted.x[mu] = rate[mu].value;
    for (int a = 0; a < N; ++a) {
      lifted.y[a] = rate[n + 1 + a].value;
      for (int mu = 0; mu <= n; ++mu) {
        // [eq_9_3]
        lifted.v(a, mu) = rate[n + 1 + a].part[mu];
        for (int nu = 0; nu <= n; ++nu) lifted.v(a, mu) -= j.v(a, nu) * rate[nu].part[mu];
        // [eq_9_3]
      }
    }
    return coordinates(lifted);
  };
}

}  // namespace actio
