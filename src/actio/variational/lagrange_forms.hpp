// The Lagrange one-form and two-form on TG.
#pragma once

#include "actio/variational/legendre.hpp"

namespace actio {

/// \f$\theta_L(v)\cdot w = \langle F L(v), \vartheta\rangle\f$: the momentum, paired with how the
/// configuration changes.
template <Group G, Scalar S, class Lagrangian>
S lagrange_one_form(Lagrangian const& L, State<G, S> const& v, StateChange<G, S> const& w) {
  // [thm_2_1_1]
  return pair(legendre(L, v), w.configuration);
  // [thm_2_1_1]
}

/// \f$\omega_L = -d\theta_L\f$ on two tangent vectors at v.
///
/// Tangent vectors with constant \f$(\vartheta, \delta\xi)\f$ are vector fields on TG whose commutator is
/// \f$-[\vartheta_1, \vartheta_2]\f$ (right-invariant fields), so that
/// \f[ d\theta_L(w_1, w_2) = w_1(\theta_L w_2) - w_2(\theta_L w_1) + \langle F L(v), [\vartheta_1,
///   \vartheta_2]\rangle . \f]
template <Group G, Scalar S, class Lagrangian>
S lagrange_two_form(Lagrangian const& L, State<G, S> const& v, StateChange<G, S> const& w1,
                    StateChange<G, S> const& w2) {
  auto const rate = [&](StateChange<G, S> const& along, StateChange<G, S> const& of) {
    auto const mu = legendre(L, moved(v, along));
    S sum(0);
    for (Index a = 0; a < mu.components.size(); ++a)
      sum += mu.components[a].part[0] * of.configuration.coordinates[a];
    return sum;
  };
  return rate(w2, w1) - rate(w1, w2) - pair(legendre(L, v), bracket(w1.configuration, w2.configuration));
}

}  // namespace actio
