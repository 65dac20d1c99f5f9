// The Euler-Lagrange derivative of a density from one evaluation of it: the fast road to (6.12) of the
// thesis.
//
// The divergence D_mu (dL/dv^a_mu) is a sum over mu of second derivatives of L: of one along the section, in
// x^mu, and of one in v^a_mu. Move the jet by an infinitesimal delta_mu along x^mu as the section goes, for
// each mu, and each v^a_mu by an infinitesimal epsilon_a^mu. In a product of the two nothing is needed but
// the sum over mu; so let delta_mu epsilon_a^mu = tau_a be the same for each mu, and all other products be
// zero. On such numbers (divergence_number.hpp) L has D_mu (dL/dv^a_mu) at tau_a. Move y^a by -tau_a as well:
// then L has D_mu (dL/dv^a_mu) - dL/dy^a there, which is minus the Euler-Lagrange derivative, for all a at
// once. The line of the thesis is `euler_lagrange_by_terms` in field_equations.hpp.
#pragma once

#include "actio/jets/density.hpp"
#include "actio/numbers/divergence_functions.hpp"

namespace actio {

/// The first jets around a second jet j: moved along each \f$x^\mu\f$ by \f$\delta_\mu\f$ as the section
/// goes, each \f$v^a{}_\mu\f$ by \f$\varepsilon_a{}^\mu\f$, and \f$y^a\f$ by \f$-\tau_a\f$.
template <class S, int n, int N>
Jet<DivergenceNumber<S, n + 1, N>, n, N> moved_for_divergence(SecondJet<S, n, N> const& j) {
  Jet<DivergenceNumber<S, n + 1, N>, n, N> moved;
  for (int mu = 0; mu <= n; ++mu) {
    moved.x[mu].set_value(j.x[mu]);
    moved.x[mu].set_rate(mu, S(1));
  }
  for (int a = 0; a < N; ++a) {
    moved.y[a].set_value(j.y[a]);
    moved.y[a].set_sum(a, S(-1));
    for (int mu = 0; mu <= n; ++mu) {
      moved.y[a].set_rate(mu, j.v(a, mu));
      moved.v(a, mu).set_value(j.v(a, mu));
      moved.v(a, mu).set_slope(mu, a, S(1));
      for (int nu = 0; nu <= n; ++nu) moved.v(a, mu).set_rate(nu, j.w[nu](a, mu));
    }
  }
  return moved;
}

/// The Euler-Lagrange derivative \f$\partial L/\partial y^a - D_\mu\,(\partial L/\partial v^a{}_\mu)\f$ at a
/// second jet (6.12): the left side of the field equations.
///
/// L is evaluated once; \ref euler_lagrange_by_terms is the same as the thesis writes it.
/// \implements{eq_6_12,eq_6_9}
/// @param j  second jet of a section, \ref second_jet
/// @return   a component for each a, per unit of \f$d^{n+1}x\f$: zero along solutions
/// @throws NoDerivative  where the density has no second derivative; and what the density itself refuses
/// Accuracy: exact but for the rounding of L.
template <class S, int n, int N, class L>
  requires DensityOver<L, S, n, N>
Matrix<S, N, 1> euler_lagrange(L const& density, SecondJet<S, n, N> const& j) {
  examine(density, static_cast<Jet<S, n, N> const&>(j));
  DivergenceNumber<S, n + 1, N> const value = density(moved_for_divergence(j));
  Matrix<S, N, 1> r;
  for (int a = 0; a < N; ++a) r[a] = -value.sum(a);
  require_derivative(r, static_cast<Jet<S, n, N> const&>(j), "euler_lagrange");
  return r;
}

/// The same along a section, at a point of space-time.
template <class S, int rows, class L, class Phi>
Matrix<S, detail::fibre_dimension<Phi, S, rows - 1>, 1> euler_lagrange(L const& density, Phi const& phi,
                                                                       Matrix<S, rows, 1> const& x) {
  return euler_lagrange(density, second_jet(phi, x));
}

}  // namespace actio
