// Equivariance of densities under automorphisms and vector fields of Y (section 9.1 of the thesis).
//
// A density is equivariant under an automorphism where L(eta gamma) d^{n+1}x at eta_X(x) is the push-forward of L(gamma) d^{n+1}x. Both forms are taken back to x here,
// so that defects are per unit of d^{n+1}x at the jet that is given.
#pragma once

#include "actio/noether/automorphism.hpp"

namespace actio {

/// The density \f$\eta^*L\f$, \f$(\eta^*L)(\gamma) = \det(T\eta_X)\,L(\eta_{J^1Y}(\gamma))\f$: what a moved section acts with, seen from where it came.
template <class L, class Eta>
struct PulledBackDensity {
  L density;  ///< L
  Eta eta;    ///< the automorphism

  /// Its value at the jet before it is moved.
  template <class S, int n, int N>
  S operator()(Jet<S, n, N> const& j) const {
    auto const d = tangent<n, N>(eta, j.x, j.y);
    return determinant(d.base) * density(prolongation(eta, j));
  }
};
/// The density pulled back by an automorphism.
template <class L, class Eta>
PulledBackDensity(L, Eta) -> PulledBackDensity<L, Eta>;

/// The defect of equivariance \f$\det(T\eta_X)\,L(\eta_{J^1Y}(\gamma)) - L(\gamma)\f$: zero where \f$L(\eta_{J^1Y}(\gamma))\,d^{n+1}x = (\eta_X^{-1})^*\bigl(L(\gamma)\,d^{n+1}x\bigr)\f$.
///
/// \implements{claim_9_1_equivariance}
/// @throws Singular  where the automorphism has no inverse; and what the density refuses
template <class L, class Eta, class S, int n, int N>
S equivariance_defect(L const& density, Eta const& eta, Jet<S, n, N> const& j) {
  detail::examine(density, j);
  // [claim_9_1_equivariance]
  return PulledBackDensity{density, eta}(j) - density(j);
  // [claim_9_1_equivariance]
}

/// The same for a vector field: \f$dL(j^1\xi) + L\,\partial_\mu\xi^\mu\f$, the coefficient of the Lie derivative of \f$L\,d^{n+1}x\f$ along \f$j^1\xi\f$.
///
/// \implements{claim_9_1_equivariance}
/// @param xi  a vector field on Y that covers one on space-time: a callable from points (x, y), one column, to their velocities, over any scalar
/// Accuracy: exact but for the rounding of L and xi.
template <class L, class Xi, class S, int n, int N>
S equivariance_rate(L const& density, Xi const& xi, Jet<S, n, N> const& j) {
  detail::examine(density, j);
  using T = Dual<S>;
  auto const at = coordinates(j);
  auto const lift = prolonged<n, N>(xi)(at);
  auto moved = at.template cast<T>().eval();
  for (int i = 0; i < moved.size(); ++i) moved[i].part[0] = lift[i];
  T const value = density(jet_at<n, N>(moved));
  // The divergence of the part of the field on space-time.
  using E = Dual<S, n + 1>;
  Matrix<E, n + 1 + N, 1> point = point_of(j).template cast<E>();
  for (int mu = 0; mu <= n; ++mu) point[mu].part[mu] = S(1);
  Matrix<E, n + 1 + N, 1> const rate = xi(point);
  S divergence(0);
  for (int mu = 0; mu <= n; ++mu) divergence += rate[mu].part[mu];
  return value.part[0] + value.value * divergence;
}

}  // namespace actio
