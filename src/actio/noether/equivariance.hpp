// Equivariance of densities under automorphisms and vector fields of Y (section 9.1 of the thesis).
//
// A density is equivariant under an automorphism where L(eta gamma) d^{n+1}x at eta_X(x) is the push-forward
// of L(gamma) d^{n+1}x. Both forms are taken back to x here, so that defects are per unit of d^{n+1}x at the
// jet that is given.
#pragma once

#include "actio/forms/metric.hpp"
#include "actio/noether/automorphism.hpp"

namespace actio {

/// The density \f$\eta^*L\f$, \f$(\eta^*L)(\gamma) = \det(T\eta_X)\,L(\eta_{J^1Y}(\gamma))\f$: what a moved
/// section acts with, seen from where it came.
template <class L, class Eta>
struct PulledBackDensity {
  L density;  ///< L
  Eta eta;    ///< the automorphism

  /// Its value at the jet before it is moved.
  template <class S, int n, int N>
  S operator()(Jet<S, n, N> const& j) const {
    auto const d = tangent<n, N>(eta, j.x, j.y);
    // [claim_9_1_lifted_actions]
    return determinant(d.base) * density(prolongation(eta, j));
    // [claim_9_1_lifted_actions]
  }
};
/// The density pulled back by an automorphism.
template <class L, class Eta>
PulledBackDensity(L, Eta) -> PulledBackDensity<L, Eta>;

/// The defect of equivariance \f$\det(T\eta_X)\,L(\eta_{J^1Y}(\gamma)) - L(\gamma)\f$: zero where
/// \f$L(\eta_{J^1Y}(\gamma))\,d^{n+1}x = (\eta_X^{-1})^*\bigl(L(\gamma)\,d^{n+1}x\bigr)\f$.
///
/// \implements{claim_9_1_equivariance}
/// @throws Singular  where the automorphism has no inverse; and what the density refuses
template <class L, class Eta, class S, int n, int N>
S equivariance_defect(L const& density, Eta const& eta, Jet<S, n, N> const& j) {
  examine(density, j);
  // [claim_9_1_equivariance]
  return PulledBackDensity{density, eta}(j)-density(j);
  // [claim_9_1_equivariance]
}

/// The same for a vector field: \f$dL(j^1\xi) + L\,\partial_\mu\xi^\mu\f$, the coefficient of the Lie
/// derivative of \f$L\,d^{n+1}x\f$ along \f$j^1\xi\f$.
///
/// \implements{claim_9_1_equivariance}
/// @param xi  a vector field on Y that covers one on space-time: a callable from points (x, y), one column,
/// to their velocities, over any scalar Accuracy: exact but for the rounding of L and xi.
template <class L, class Xi, class S, int n, int N>
S equivariance_rate(L const& density, Xi const& xi, Jet<S, n, N> const& j) {
  examine(density, j);
  auto const at = coordinates(j);
  auto const on_coordinates = [&](auto const& moved) { return density(jet_at<n, N>(moved)); };
  auto const [value, rate] = derivative_along(on_coordinates, at, prolonged<n, N>(xi)(at));
  // The part of the field on space-time, which does not depend on y.
  auto const xi_X = [&]<class T>(Event<T, n> const& x) -> Event<T, n> {
    Matrix<T, n + 1 + N, 1> point;
    point << x, j.y.template cast<T>();
    return xi(point).template head<n + 1>();
  };
  // [rate_of_equivariance]
  return rate + value * divergence(xi_X, j.x);
  // [rate_of_equivariance]
}

}  // namespace actio
