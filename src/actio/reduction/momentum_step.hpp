// Steps of the discrete Lie-Poisson algorithm as maps of the momentum, of any length, forwards or backwards.
//
// A discrete Lagrangian is an action, so its momenta are physical: the momentum at the end of a step is that
// at the start of the next, whatever the lengths of the two. An integrator on momenta is a callable (state,
// h) -> MomentumStep. Such steps follow each other, are composed (composition.hpp) and exchanged
// (galerkin.hpp) independently of each other. The momentum is spatial in right-invariant systems, that of the
// body in left-invariant ones; configurations follow from the relative motions where they are asked for.
#pragma once

#include <utility>

#include "actio/reduction/discrete_lie_poisson.hpp"
#include "actio/reduction/natural_chart.hpp"
#include "actio/reduction/remembered_solutions.hpp"

namespace actio {

/// The state of a run on momenta between two steps.
template <Group G, Scalar S>
struct MomentumState {
  Momentum<G, S> momentum;  ///< energy x time; spatial (right-invariant) or of the body (left-invariant)
  /// 1/time; from where the next step looks for its relative motion, no part of the map of momenta
  Velocity<G, S> velocity;
};

/// The state with velocity \f$\xi\f$ and momentum \f$\partial l/\partial\xi\f$.
template <Group G, Scalar S, class F>
MomentumState<G, S> momentum_state(F const& l, Velocity<G, S> const& xi) { return {gradient(l, xi), xi}; }

/// What a step on momenta has done.
template <Group G, Scalar S>
struct MomentumStep {
  Element<G, S> relative_motion;  ///< f, for \ref reconstruct_right or \ref reconstruct_left
  MomentumState<G, S> state;      ///< at the end of the step
  int evaluations = 0;            ///< how often a residual was evaluated, with its derivative
};

namespace detail {
/// A momentum that can be stepped.
template <Group G, Scalar S>
void require_steppable(MomentumState<G, S> const& from, Base<S> const& h) {
  nonzero_step(h);
  require_finite(from.momentum.components, "momentum step: momentum");
  require_finite(from.velocity.coordinates, "momentum step: velocity");
}
}  // namespace detail

/// The step of an invariant system as a map of the momentum: solves the momentum equation and transports the
/// momentum by \f$\mathrm{Ad}^*\f$.
///
/// Steps of one length that follow each other are solved for as those of \ref EulerPoincareSteps: what one
/// has found out about the equation serves the next. A step remembers it, and belongs to one thread at a
/// time.
/// @tparam Invariance  \ref RightInvariant or \ref LeftInvariant
template <class Invariance, class Family>
struct LiePoissonStep {
  Family family;                                ///< h -> reduced discrete Lagrangian
  detail::RememberedSolutions remembered = {};  ///< of the last calls

  /// A step of length h from a state.
  /// @throws OutsideDomain           for a step that is zero or not finite
  /// @throws NotConverged, Singular  where the step is too long for the momentum
  template <ExponentialGroup G, Real S>
  MomentumStep<G, S> operator()(MomentumState<G, S> const& from,
                                std::type_identity_t<Base<S>> const& h) const {
    detail::require_steppable(from, h);
    auto const l = family(h);
    auto& solver = remembered.template solver<G>(from.velocity, h);
    auto const f = solver.solve(Invariance::momentum_equation(l, from.momentum), exp(S(-h) * from.velocity));
    return {
        f, {Invariance::lie_poisson_update(f, from.momentum), log(f) / S(-h)}, solver.report().evaluations};
  }
};

/// The step of a right-invariant system: solves \f$-R_f^*\ell_h'(f) = \mu\f$ and transports \f$\mu\f$ to
/// \f$\mathrm{Ad}^*_f\,\mu\f$ (3.17).
///
/// \implements{claim_4_3_time_step_legendre}
/// @param family  h -> reduced discrete Lagrangian, an action, at steps of either sign. Where it is
///                self-adjoint, \f$\ell_{-h}(f^{-1}) = -\ell_h(f)\f$, a step by -h undoes one by h.
template <class Family>
auto lie_poisson_step_right(Family family) {
  return LiePoissonStep<RightInvariant, Family>{std::move(family)};
}
/// The step of a left-invariant system: solves \f$-L_f^*\ell_h'(f) = \Pi\f$ and transports \f$\Pi\f$ to
/// \f$\mathrm{Ad}^*_{f^{-1}}\,\Pi\f$ (3.18). Otherwise as \ref lie_poisson_step_right.
template <class Family>
auto lie_poisson_step_left(Family family) { return LiePoissonStep<LeftInvariant, Family>{std::move(family)}; }

/// The step by the natural chart (3.25) of a right-invariant system: order 2, self-adjoint.
/// @param l  reduced Lagrangian, function of \f$\dot g g^{-1}\f$, energy
template <class F>
auto natural_chart_step_right(F l) {
  return lie_poisson_step_right([l](auto const& h) { return natural_chart_lagrangian_right(l, h); });
}
/// The step by the natural chart (3.25) of a left-invariant system: order 2, self-adjoint.
///
/// \snippet reduction.cpp natural_chart_step_left
/// @param l  reduced Lagrangian, function of \f$g^{-1}\dot g\f$, energy
template <class F>
auto natural_chart_step_left(F l) {
  return lie_poisson_step_left([l](auto const& h) { return natural_chart_lagrangian_left(l, h); });
}

/// Steps of prescribed lengths, one after another; the state at the end.
///
/// @param step     (state, h) -> \ref MomentumStep
/// @param lengths  h_1, h_2, ..., of either sign and as unequal as they may be
/// @param visit    called with each step done and its length
/// @throws         what the step throws, at the first length that it cannot take
template <class Step, Group G, Scalar S, class Lengths, class Visit>
MomentumState<G, S> take_steps(Step const& step, MomentumState<G, S> state, Lengths const& lengths,
                               Visit const& visit) {
  for (auto const& h : lengths) {
    auto done = step(state, h);
    visit(std::as_const(done), h);
    state = std::move(done.state);
  }
  return state;
}

/// Steps of prescribed lengths, with nothing asked on the way.
template <class Step, Group G, Scalar S, class Lengths>
MomentumState<G, S> take_steps(Step const& step, MomentumState<G, S> const& start, Lengths const& lengths) {
  return take_steps(step, start, lengths, [](auto const&, auto const&) {});
}

}  // namespace actio
