// Momentum maps: what a symmetry conserves (Noether).
//
// A one-parameter group acting on G has a generator at each g; translated to the identity on the right it is
// a function g -> theta(g). Multiplication from the left by exp(t zeta) has theta = zeta; multiplication from
// the right by exp(t zeta) has theta = Ad_g zeta.
#pragma once

#include "actio/variational/lagrange_forms.hpp"

namespace actio {

/// \f$J(v) = \langle F L(v), \vartheta(g)\rangle\f$: the contraction of the lifted generator with
/// \f$\theta_L\f$.
///
/// \implements{claim_2_1_noether_momentum}
/// @param generator  Element at any scalar -> Velocity at the same: the generator on G, translated to the
///   identity on the right
template <Group G, Scalar S, class Lagrangian, class Generator>
S noether_momentum(Lagrangian const& L, State<G, S> const& v, Generator const& generator) {
  // [claim_2_1_noether_momentum]
  return pair(legendre(L, v), generator(v.configuration));
  // [claim_2_1_noether_momentum]
}

/// The generator of \f$g \mapsto e^{t\zeta}g\f$.
template <Group G, Scalar S>
auto left_translation(Velocity<G, S> zeta) { return [zeta](auto const& g) { return like(g, zeta); }; }
/// The generator of \f$g \mapsto g\,e^{t\zeta}\f$.
template <Group G, Scalar S>
auto right_translation(Velocity<G, S> zeta) { return [zeta](auto const& g) { return Ad(g, like(g, zeta)); }; }

/// A generator lifted to TG: how it moves a state, \f$(\vartheta, \delta\xi)\f$ with
/// \f$\delta\xi = \frac{d}{dt}\vartheta - [\xi, \vartheta]\f$ along the motion of the state.
template <Group G, Scalar S, class Generator>
StateChange<G, S> lifted_generator(State<G, S> const& v, Generator const& generator) {
  Velocity<G, S> const none{v.configuration.group,
                            Coordinates<G, S>::Zero(v.configuration.group.dimension())};
  auto const along = generator(moved(v, {v.velocity, none}).configuration);
  Velocity<G, S> theta = none, rate = none;
  for (Index a = 0; a < theta.coordinates.size(); ++a) {
    theta.coordinates[a] = along.coordinates[a].value;
    rate.coordinates[a] = along.coordinates[a].part[0];
  }
  return {theta, rate - bracket(v.velocity, theta)};
}

}  // namespace actio
