// Steps of order 8 on a level of the momentum, with a vector that the motion advects.
//
// Momentum and vector are a covector of the semidirect product of the group with the covectors of the space
// of vectors, and move on its coadjoint orbit: (Pi, a)' = ad*_(xi, w) (Pi, a), where l'(xi) = Pi and
// w = -dl/da. Each step moves them by the coadjoint action of one element, first by a covector, the integral
// of w in coordinates at the start of the step, then by the group. So every Casimir is conserved to rounding,
// whatever the error of the step.
#pragma once

#include <any>
#include <optional>
#include <utility>

#include "actio/reduction/advected.hpp"
#include "actio/reduction/momentum_level.hpp"

namespace actio {

/// The state of a run on momenta with an advected vector, between two steps.
template <Group G, Scalar S, int m>
struct AdvectedMomentumState {
  Momentum<G, S> momentum;  ///< energy x time; spatial (right-invariant) or of the body (left-invariant)
  Matrix<S, m, 1> vector;   ///< \f$g^{-1}c\f$ (left-invariant) or \f$g\,c\f$ (right-invariant)
  Velocity<G, S> velocity;  ///< 1/time; near which the next step looks for that of the momentum
};

/// The state with velocity \f$\xi\f$, momentum \f$\partial l/\partial\xi\f$ and vector a.
/// @param l  (velocity, vector) -> energy
template <Group G, Scalar S, int m, class F>
AdvectedMomentumState<G, S, m> advected_momentum_state(F const& l, Velocity<G, S> const& xi,
                                                       Matrix<S, m, 1> const& a) {
  return {gradient(detail::holding(l, a), xi), a, xi};
}

/// What a step with an advected vector has done.
template <Group G, Scalar S, int m>
struct AdvectedMomentumStep {
  Element<G, S> relative_motion;         ///< f, for \ref reconstruct_right or \ref reconstruct_left
  AdvectedMomentumState<G, S, m> state;  ///< at the end of the step
  int evaluations = 0;                   ///< of gradients of the Lagrangian
  S work = S(0);                         ///< of a force over the step, energy
  /// what a force adds over the step to the momentum of the symmetry, where the configuration at its start is
  /// the identity; empty without a force
  std::optional<Momentum<G, S>> impulse = {};
};

namespace detail {

/// \f$\partial l/\partial a\f$ of a Lagrangian (velocity, vector) -> energy.
template <class F, Group G, Scalar S, int m>
Matrix<S, m, 1> slope_in_vector(F const& l, Velocity<G, S> const& xi, Matrix<S, m, 1> const& a) {
  if (a.size() == 0) return a;
  return derivative([&](auto const& moved) { return l(like(moved, xi), moved); }, a).gradient();
}

/// A step on a level of the momentum with an advected vector; side: +1 right, -1 left.
template <int side, class F, Real B, class Act>
class AdvectedMomentumLevelStep {
 public:
  AdvectedMomentumLevelStep(F l, Act act) : l_(std::move(l)), act_(std::move(act)) {}

  /// A step of length h from a state.
  template <ExponentialGroup G, Real S, int m>
  AdvectedMomentumStep<G, S, m> operator()(AdvectedMomentumState<G, S, m> const& from,
                                           std::type_identity_t<B> const& h) const {
    require_steppable(MomentumState<G, S>{from.momentum, from.velocity}, h);
    require_finite(from.vector, "momentum step: vector");
    using V = Coordinates<G, S>;
    using U = Matrix<S, m, 1>;
    using Memory = LevelMemory<G, S, side, B, V, U>;
    auto& kept = Memory::of(memory_, from.velocity, U::Zero(from.vector.size()),
                            [&] { return VectorAction<B>(from.momentum.group, from.vector.size(), act_); });
    auto const velocity_of = [&](int stage, V const& mu, U const& a, V& xi, U& w) {
      bool const check = Memory::Flow::checks(stage);
      if (!kept.velocities.find(holding(l_, a), mu, check)) return false;
      auto const& found = kept.velocities.velocity();
      xi = found.coordinates;
      if (a.size() == 0) return true;
      bool const goes_on = kept.slopes.find(stage == 0, check, [&] {
        // [advected_momentum_level]
        return slope_in_vector(l_, found, a);
        // [advected_momentum_level]
      });
      w = -kept.slopes.slope();
      return goes_on;
    };
    V eta = V::Zero(from.momentum.components.size());
    for (int tried = 0; tried < 3; ++tried) {
      kept.velocities.begin(holding(l_, from.vector), from.velocity);
      if (kept.flow(from.momentum.components, from.vector, h, velocity_of, eta)) break;
    }
    auto pushed = from.momentum;
    kept.flow.push(from.vector, pushed.components);
    auto const f = exp(Velocity<G, S>{from.momentum.group, -eta});
    return {f,
            {Invariance::lie_poisson_update(f, pushed), advect(f, from.vector), kept.velocities.velocity()},
            kept.velocities.take_gradients() + kept.slopes.take_evaluations()};
  }

 private:
  using Invariance = std::conditional_t<(side > 0), RightInvariant, LeftInvariant>;
  template <Group G, Real S, int m>
  Matrix<S, m, 1> advect(Element<G, S> const& f, Matrix<S, m, 1> const& a) const {
    if (a.size() == 0) return a;
    if constexpr (side > 0)
      return advect_right(f, a, act_);
    else
      return advect_left(f, a, act_);
  }
  F l_;
  [[no_unique_address]] Act act_;
  mutable std::any memory_;  // of the last call
};

}  // namespace detail

/// A step of order 8 of a left-invariant system with an advected vector on a level of its momenta: a callable
/// (state, h) -> \ref AdvectedMomentumStep.
///
/// Solves \f$\dot\Pi = \mathrm{ad}^*_\xi\,\Pi - \langle\partial l/\partial a, \cdot\,a\rangle\f$,
/// \f$\dot a = -\xi a\f$ with \f$\partial l/\partial\xi = \Pi\f$ in the chart of the group, as
/// \ref momentum_level_step_left does. The torque is integrated by the same method in coordinates at the
/// start of the step, where the vector is fixed.
/// @param l    reduced Lagrangian, function of \f$g^{-1}\dot g\f$ and of \f$a = g^{-1}c\f$, energy; its
///             Legendre map is regular
/// @param act  the action of the group on vectors
/// @throws OutsideDomain  when called, for a step that is zero or not finite
/// @throws NotConverged, Singular  when called, where the velocity of a momentum is not found
template <Real S, class F, class Act = MatrixAction>
auto advected_momentum_level_step_left(F l, Act act = {}) {
  return detail::AdvectedMomentumLevelStep<-1, F, S, Act>{std::move(l), std::move(act)};
}
/// The same of a right-invariant system, with \f$a = g\,c\f$ and \f$\dot a = \xi a\f$.
/// @param l  reduced Lagrangian, function of \f$\dot g g^{-1}\f$ and of a, energy
template <Real S, class F, class Act = MatrixAction>
auto advected_momentum_level_step_right(F l, Act act = {}) {
  return detail::AdvectedMomentumLevelStep<1, F, S, Act>{std::move(l), std::move(act)};
}

}  // namespace actio
