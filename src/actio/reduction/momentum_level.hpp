// Explicit steps of order 8 that conserve the momentum of the symmetry by construction.
//
// On a level of that momentum the velocity is a function of the configuration: l'(xi) is the constant
// momentum, transported by Ad*. So a motion is a solution of a first-order equation on G, which a Runge-Kutta
// method solves in the natural chart at the earlier configuration. The momentum at the end of a step is that
// at its start, transported by the relative motion: it stays on its coadjoint orbit, and every Casimir and
// the momentum of the symmetry are what they were, whatever the error of the step. The step is no variational
// one: it does not preserve the bracket, and nothing bounds the error of the energy.
#pragma once

#include <any>
#include <utility>

#include "actio/reduction/momentum_step.hpp"
#include "actio/reduction/stage_velocities.hpp"

namespace actio {

namespace detail {

/// A step on a level of the momentum; side: +1 right, -1 left.
template <int side, class F, Real B>
struct MomentumLevelStep {
  F l;
  mutable std::any memory = {};  ///< of the last call

  template <ExponentialGroup G, Real S>
  MomentumStep<G, S> operator()(MomentumState<G, S> const& from, std::type_identity_t<B> const& h) const {
    require_steppable(from, h);
    using V = Coordinates<G, S>;
    using None = Matrix<S, 0, 1>;
    using Memory = LevelMemory<G, S, side, B, V, None>;
    auto& kept = Memory::of(memory, from.velocity, None(), [] { return VectorAction<B>(); });
    auto& velocities = kept.velocities;
    auto const velocity_of = [&](int stage, V const& mu, None const&, V& xi, None&) {
      if (!velocities.find(l, mu, Memory::Flow::checks(stage))) return false;
      xi = velocities.velocity().coordinates;
      return true;
    };
    V eta = V::Zero(from.momentum.group.dimension());
    for (int tried = 0; tried < 2; ++tried) {
      velocities.begin(l, from.velocity);
      if (kept.flow(from.momentum.components, None(), h, velocity_of, eta)) break;
    }
    auto const f = exp(Velocity<G, S>{from.momentum.group, -eta});
    using Invariance = std::conditional_t<(side > 0), RightInvariant, LeftInvariant>;
    return {f,
            {Invariance::lie_poisson_update(f, from.momentum), velocities.velocity()},
            velocities.take_gradients()};
  }
};

}  // namespace detail

/// A step of order 8 of a left-invariant system on a level of the momentum of its symmetry: a callable
/// (state, h) -> \ref MomentumStep on body momenta.
///
/// Solves \f$\dot g = g\,\xi\f$ with \f$\partial l/\partial\xi = \Pi\f$ by Fehlberg's explicit method of
/// order 8 in the natural chart at g0, and transports \f$\Pi_1 = \mathrm{Ad}^*_{f^{-1}}\,\Pi_0\f$.
/// @param l  reduced Lagrangian, function of \f$g^{-1}\dot g\f$, energy; its Legendre map is regular
/// @throws OutsideDomain  when called, for a step that is zero or not finite
/// @throws NotConverged, Singular  when called, where the velocity of a momentum is not found
template <Real S, class F>
auto momentum_level_step_left(F l) { return detail::MomentumLevelStep<-1, F, S>{std::move(l)}; }
/// The same of a right-invariant system, on spatial momenta: \f$\mu_1 = \mathrm{Ad}^*_f\,\mu_0\f$.
/// @param l  reduced Lagrangian, function of \f$\dot g g^{-1}\f$, energy
template <Real S, class F>
auto momentum_level_step_right(F l) { return detail::MomentumLevelStep<1, F, S>{std::move(l)}; }

}  // namespace actio
