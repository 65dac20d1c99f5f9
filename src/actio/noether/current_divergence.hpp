// The divergence of the Noether current of any section (section 9.1 of the thesis).
//
// Off shell, and for any density and any field: D_mu J^mu = r - E_a (xi^a - v^a_mu xi^mu), with the rate r of
// equivariance and the Euler-Lagrange derivative E. Noether's theorem is the special case r = 0 and E = 0.
#pragma once

#include "actio/jets/field_equations.hpp"
#include "actio/noether/covariant_momentum_map.hpp"
#include "actio/noether/equivariance.hpp"

namespace actio {

/// The divergence \f$D_\mu J^\mu\f$ of the Noether current along a section, the coefficient of
/// \f$d\bigl((j^1\phi)^*J_L(\xi)\bigr)\f$, by differentiation of the current.
///
/// \snippet fields.cpp current_divergence
///
/// \implements{eq_9_5}
/// @param j  second jet of the section
/// Accuracy: exact but for the rounding of L and xi.
template <class L, class Xi, class S, int n, int N>
S current_divergence(L const& density, Xi const& xi, SecondJet<S, n, N> const& j) {
  examine(density, static_cast<Jet<S, n, N> const&>(j));
  S sum(0);
  // [eq_9_5]
  for (int mu = 0; mu <= n; ++mu)
    sum += total_derivative(
        mu, [&](auto const& z) { return noether_current(density, xi, z, mu); }, j);
  // [eq_9_5]
  return sum;
}

/// What Noether's theorem says it is: \f$-E_a\,(\xi^a - v^a{}_\mu\xi^\mu)\f$ for equivariant densities, and
/// zero along solutions.
///
/// \implements{thm_9_1_1}
/// @throws what \ref euler_lagrange does
template <class L, class Xi, class S, int n, int N>
S noether_identity(L const& density, Xi const& xi, SecondJet<S, n, N> const& j) {
  Jet<S, n, N> const& first = j;
  Variation<S, n, N> const V = xi(point_of(first));
  // [noether_identity]
  return -euler_lagrange(density, j).dot(vertical_part(first, V));
  // [noether_identity]
}

}  // namespace actio
