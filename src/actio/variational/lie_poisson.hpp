// Lie-Poisson brackets and equations on the dual of the algebra.
//
// The sign of a bracket is that of the identification it comes from: with the canonical bracket {q, p} = +1
// and the commutator in the algebra, right-invariant functions on T*G give the plus bracket, left-invariant
// ones the minus bracket.
#pragma once

#include "actio/groups/differential.hpp"

namespace actio {

/// \f$\{F, H\}_+(\mu) = \langle\mu, [\delta F/\delta\mu, \delta H/\delta\mu]\rangle\f$.
///
/// \implements{thm_2_2_2}
template <Group G, Scalar S, class F, class H>
S lie_poisson_bracket_plus(F const& f, H const& h, Momentum<G, S> const& mu) {
  // [thm_2_2_2]
  return pair(mu, bracket(gradient(f, mu), gradient(h, mu)));
  // [thm_2_2_2]
}
/// \f$\{F, H\}_- = -\{F, H\}_+\f$.
template <Group G, Scalar S, class F, class H>
S lie_poisson_bracket_minus(F const& f, H const& h, Momentum<G, S> const& mu) {
  return -lie_poisson_bracket_plus(f, h, mu);
}

/// \f$\dot\mu = -\mathrm{ad}^*_{\partial h/\partial\mu}\,\mu\f$: the Lie-Poisson equations of a
/// right-invariant Hamiltonian.
///
/// \implements{thm_2_2_3}
template <Group G, Scalar S, class H>
Momentum<G, S> lie_poisson_rate_right(H const& h, Momentum<G, S> const& mu) {
  // [thm_2_2_3]
  return -ad_star(gradient(h, mu), mu);
  // [thm_2_2_3]
}
/// \f$\dot\mu = +\mathrm{ad}^*_{\partial h/\partial\mu}\,\mu\f$: the Lie-Poisson equations of a
/// left-invariant Hamiltonian.
///
/// \snippet bodies.cpp lie_poisson
template <Group G, Scalar S, class H>
Momentum<G, S> lie_poisson_rate_left(H const& h, Momentum<G, S> const& mu) {
  return ad_star(gradient(h, mu), mu);
}

/// The matrix of the plus bracket at mu: \f$\{\mu_a, \mu_b\}_+ = \langle\mu, [e_a, e_b]\rangle\f$.
template <Group G, Scalar S>
auto lie_poisson_tensor_plus(Momentum<G, S> const& mu) {
  int const n = mu.group.dimension();
  Matrix<S, G::dim, G::dim> tensor(n, n);
  for (int a = 0; a < n; ++a)
    for (int b = 0; b < n; ++b)
      tensor(a, b) = pair(mu, bracket(basis_velocity<S>(mu.group, a), basis_velocity<S>(mu.group, b)));
  return tensor;
}

}  // namespace actio
