// First variations of a section: the boundary term of the action, the linearised field equations and the current that two variations make (section 6.2
// of the thesis).
//
// A vertical variation V moves the places of a section and leaves space-time alone: to first order the section is phi + eps V, and V has jets as a section has.
// A variation that is not vertical has n + 1 + N components, \f$V^\mu\f$ first; what the field equations see of it is its vertical part.
#pragma once

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
/// @param V  variation at its place, horizontal components first
/// @return   a component for each \f$\mu\f$; for a symmetry, its Noether current
/// @throws NoDerivative  where the density has none; and what the density itself refuses
template <class S, int n, int N, class L>
  requires DensityOver<L, S, n, N>
Event<S, n> boundary_current(L const& density, Jet<S, n, N> const& j, Variation<S, n, N> const& V) {
  auto const p = momenta(density, j);
  auto const q = vertical_part(j, V);
  S const value = density(j);
  Event<S, n> B;
  // [eq_6_7]
  for (int mu = 0; mu <= n; ++mu) {
    B[mu] = value * V[mu];
    for (int a = 0; a < N; ++a) B[mu] += p(a, mu) * q[a];
  }
  // [eq_6_7]
  return B;
}

/// The jets of \f$\phi + \epsilon V\f$ to first order in \f$\epsilon\f$.
/// @param j  second jet of the section, @param V  second jet of the vertical variation, as of a section
template <class S, int n, int N>
SecondJet<Dual<S>, n, N> varied(SecondJet<S, n, N> const& j, SecondJet<S, n, N> const& V) {
  SecondJet<Dual<S>, n, N> moved;
  moved.x = j.x.template cast<Dual<S>>();
  for (int a = 0; a < N; ++a) {
    moved.y[a].value = j.y[a], moved.y[a].part[0] = V.y[a];
    for (int mu = 0; mu <= n; ++mu) {
      moved.v(a, mu).value = j.v(a, mu), moved.v(a, mu).part[0] = V.v(a, mu);
      for (int nu = 0; nu <= n; ++nu) moved.w[mu](a, nu).value = j.w[mu](a, nu), moved.w[mu](a, nu).part[0] = V.w[mu](a, nu);
    }
  }
  return moved;
}

/// The linearised field equations \f$\frac{d}{d\epsilon}E[\phi + \epsilon V]\f$: V is a first variation of a solution where they vanish.
///
/// \implements{thm_6_2_2}
/// @param j  second jet of the section, @param V  second jet of the vertical variation
/// @throws NoDerivative  where the density has no third derivative; and what the density itself refuses
/// Accuracy: exact but for the rounding of L.
template <class S, int n, int N, class L>
  requires DensityOver<L, S, n, N>
Matrix<S, N, 1> linearised_euler_lagrange(L const& density, SecondJet<S, n, N> const& j, SecondJet<S, n, N> const& V) {
  return detail::rates<S, N, 1>(euler_lagrange(density, varied(j, V)));
}

/// The current \f$\omega^\mu = \delta_Vp_a{}^\mu\,W^a - \delta_Wp_a{}^\mu\,V^a\f$ of two vertical variations:
/// \f$(j^1\phi)^*(j^1V\lrcorner j^1W\lrcorner\,\Omega_L) = \omega^\mu\,d^nx_\mu\f$ (6.11).
///
/// Its divergence is \f$V\cdot\delta_WE - W\cdot\delta_VE\f$: it vanishes for two first variations, which is the multisymplectic form formula.
///
/// \implements{eq_6_11}
/// @param j  first jet of the section
/// @param V  first jet of one variation
/// @param W  first jet of the other
/// @throws NoDerivative  where the density has no second derivative; and what the density itself refuses
template <class S, int n, int N, class L>
  requires DensityOver<L, S, n, N>
Event<S, n> multisymplectic_current(L const& density, Jet<S, n, N> const& j, Jet<S, n, N> const& V, Jet<S, n, N> const& W) {
  auto const moved_momenta = [&](Jet<S, n, N> const& by) {
    auto moved = j.template cast<Dual<S>>();
    for (int a = 0; a < N; ++a) {
      moved.y[a].part[0] = by.y[a];
      for (int mu = 0; mu <= n; ++mu) moved.v(a, mu).part[0] = by.v(a, mu);
    }
    return detail::rates<S, N, n + 1>(momenta(density, moved));
  };
  auto const of_V = moved_momenta(V), of_W = moved_momenta(W);
  // [eq_6_11]
  Event<S, n> const current = of_V.transpose() * W.y - of_W.transpose() * V.y;
  // [eq_6_11]
  return current;
}

/// The divergence \f$\partial_\mu B^\mu\f$ of a field on space-time.
/// @param B  a callable from points of space-time, over any scalar, to n + 1 components
template <class S, int rows, class Field>
S divergence(Field const& B, Matrix<S, rows, 1> const& x) {
  using D = Dual<S, rows>;
  Matrix<D, rows, 1> moved = x.template cast<D>();
  for (int mu = 0; mu < rows; ++mu) moved[mu].part[mu] = S(1);
  Matrix<D, rows, 1> const value = B(moved);
  S sum(0);
  for (int mu = 0; mu < rows; ++mu) sum += value[mu].part[mu];
  return sum;
}

}  // namespace actio
