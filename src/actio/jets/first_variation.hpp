// First variations of a section: the boundary term of the action, the linearised field equations and the
// current that two variations make (section 6.2 of the thesis).
//
// A vertical variation V moves the values of a section and leaves space-time fixed: to first order the
// section is phi + eps V, and V has jets as a section has. A variation that is not vertical has n + 1 + N
// components, \f$V^\mu\f$ first; what the field equations see of it is its vertical part.
#pragma once

#include "actio/forms/metric.hpp"
#include "actio/jets/field_equations.hpp"

namespace actio {

/// A tangent vector of Y: \f$(V^\mu, V^a)\f$.
template <class S, int n, int N>
using Variation = Matrix<S, n + 1 + N, 1>;

/// The vertical part \f$V^a - v^a{}_\mu V^\mu\f$ of a variation at a jet.
///
/// \implements{claim_6_2_vertical_variations}
template <class S, int n, int N>
Matrix<S, N, 1> vertical_part(Jet<S, n, N> const& j, Variation<S, n, N> const& V) {
  Matrix<S, N, 1> q;
  for (int a = 0; a < N; ++a) {
    // [claim_6_2_vertical_variations]
    q[a] = V[n + 1 + a];
    for (int mu = 0; mu <= n; ++mu) q[a] -= j.v(a, mu) * V[mu];
    // [claim_6_2_vertical_variations]
  }
  return q;
}

/// The boundary term of the action's variation, \f$B^\mu = p_a{}^\mu\,(V^a - v^a{}_\nu V^\nu) + L\,V^\mu\f$:
/// \f$(j^1\phi)^*(j^1V\lrcorner\,\Theta_L) = B^\mu\,d^nx_\mu\f$ (6.7).
///
/// \implements{eq_6_7}
/// @param j  first jet of the section
/// @param V  variation at that point, horizontal components first
/// @return   a component for each \f$\mu\f$; for a symmetry, its Noether current
/// @throws NoDerivative  where the density has none; and what the density itself refuses
template <class S, int n, int N, class L>
  requires DensityOver<L, S, n, N>
Event<S, n> boundary_current(L const& density, Jet<S, n, N> const& j, Variation<S, n, N> const& V) {
  auto const p = momenta(density, j);
  auto const q = vertical_part(j, V);
  S const value = density(j);
  // [eq_6_7]
  return p.transpose() * q + V.template head<n + 1>() * value;
  // [eq_6_7]
}

/// The first jet of \f$\phi + \epsilon V\f$ to first order in \f$\epsilon\f$.
/// @param j  first jet of the section, @param V  first jet of the vertical variation, as of a section
template <class S, int n, int N>
Jet<Dual<S>, n, N> varied(Jet<S, n, N> const& j, Jet<S, n, N> const& V) {
  return {j.x.template cast<Dual<S>>(), moved_along(j.y, V.y), moved_along(j.v, V.v)};
}
/// The second jet of \f$\phi + \epsilon V\f$ to first order in \f$\epsilon\f$.
/// @param j  second jet of the section, @param V  second jet of the vertical variation, as of a section
template <class S, int n, int N>
SecondJet<Dual<S>, n, N> varied(SecondJet<S, n, N> const& j, SecondJet<S, n, N> const& V) {
  SecondJet<Dual<S>, n, N> moved;
  static_cast<Jet<Dual<S>, n, N>&>(moved) =
      varied(static_cast<Jet<S, n, N> const&>(j), static_cast<Jet<S, n, N> const&>(V));
  for (int mu = 0; mu <= n; ++mu) moved.w[mu] = moved_along(j.w[mu], V.w[mu]);
  return moved;
}

/// The linearised field equations \f$\frac{d}{d\epsilon}E[\phi + \epsilon V]\f$: V is a first variation of a
/// solution where they vanish.
///
/// \implements{thm_6_2_2}
/// @param j  second jet of the section, @param V  second jet of the vertical variation
/// @throws NoDerivative  where the density has no third derivative; and what the density itself refuses
/// Accuracy: exact but for the rounding of L.
template <class S, int n, int N, class L>
  requires DensityOver<L, S, n, N>
Matrix<S, N, 1> linearised_euler_lagrange(L const& density, SecondJet<S, n, N> const& j,
                                          SecondJet<S, n, N> const& V) {
  examine(density, static_cast<Jet<S, n, N> const&>(j));
  return rate_of(euler_lagrange(density, varied(j, V)));
}

/// The current \f$\omega^\mu = \delta_Vp_a{}^\mu\,W^a - \delta_Wp_a{}^\mu\,V^a\f$ of two vertical variations:
/// \f$(j^1\phi)^*(j^1V\lrcorner j^1W\lrcorner\,\Omega_L) = \omega^\mu\,d^nx_\mu\f$ (6.11).
///
/// Its divergence is \f$V\cdot\delta_WE - W\cdot\delta_VE\f$: it vanishes for two first variations, which is
/// the multisymplectic form formula.
///
/// \implements{eq_6_11}
/// @param j  first jet of the section
/// @param V  first jet of one variation
/// @param W  first jet of the other
/// @throws NoDerivative  where the density has no second derivative; and what the density itself refuses
template <class S, int n, int N, class L>
  requires DensityOver<L, S, n, N>
Event<S, n> multisymplectic_current(L const& density, Jet<S, n, N> const& j, Jet<S, n, N> const& V,
                                    Jet<S, n, N> const& W) {
  examine(density, j);
  auto const delta_p = [&](Jet<S, n, N> const& by) { return rate_of(momenta(density, varied(j, by))); };
  // [eq_6_11]
  Event<S, n> const current = delta_p(V).transpose() * W.y - delta_p(W).transpose() * V.y;
  // [eq_6_11]
  return current;
}

}  // namespace actio
