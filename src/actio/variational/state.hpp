// Points of TG, and Lagrangians on it.
//
// A point (g, g') of TG is written (g, xi) with the velocity translated to the identity on the right, xi = g'
// g^-1: the spatial velocity. The body velocity is Ad(g^-1) xi. A Lagrangian is any callable
// l(state), at every scalar.
//
// A tangent vector to TG is written (theta, d xi): theta = dg g^-1 and the change of xi.
#pragma once

#include "actio/groups/differential.hpp"

namespace actio {

/// A point of TG: configuration and velocity, translated to the identity on the right.
template <Group G, Scalar S>
struct State {
  using Scalar = S;
  Element<G, S> configuration;
  Velocity<G, S> velocity;  ///< \f$\xi = \dot g\,g^{-1}\f$
};

/// A tangent vector to TG at a state.
template <Group G, Scalar S>
struct StateChange {
  Velocity<G, S> configuration;  ///< \f$\vartheta = \delta g\,g^{-1}\f$
  Velocity<G, S> velocity;       ///< \f$\delta\xi\f$
};

/// The body velocity, \f$g^{-1}\dot g\f$.
template <Group G, Scalar S>
Velocity<G, S> body_velocity(State<G, S> const& v) { return Ad(inverse(v.configuration), v.velocity); }

/// The same state over a larger scalar, where it is a constant.
template <Scalar T, Group G, Scalar S>
State<G, T> over(State<G, S> const& v) { return {over<T>(v.configuration), over<T>(v.velocity)}; }

/// A state moved infinitely little along a tangent vector: the dual number's only direction.
template <Group G, Scalar S>
State<G, Dual<S>> moved(State<G, S> const& v, StateChange<G, S> const& w) {
  using D = Dual<S>;
  int const n = v.configuration.group.dimension();
  Coordinates<G, D> theta = Coordinates<G, D>::Zero(n);
  Velocity<G, D> velocity = over<D>(v.velocity);
  for (int a = 0; a < n; ++a) {
    theta[a].part[0] = w.configuration.coordinates[a];
    velocity.coordinates[a].part[0] = w.velocity.coordinates[a];
  }
  Element<G, D> const step{v.configuration.group, primitive::near_identity(v.configuration.group, theta)};
  return {step * over<D>(v.configuration), velocity};
}

/// A right-invariant Lagrangian on TG from its restriction to the algebra:
/// \f$L(g, \dot g) = l(\dot g g^{-1})\f$.
template <class F>
auto right_invariant(F l) { return [l](auto const& state) { return l(state.velocity); }; }
/// A left-invariant Lagrangian on TG from its restriction to the algebra:
/// \f$L(g, \dot g) = l(g^{-1}\dot g)\f$.
template <class F>
auto left_invariant(F l) { return [l](auto const& state) { return l(body_velocity(state)); }; }

}  // namespace actio
