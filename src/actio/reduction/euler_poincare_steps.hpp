// Motions by the discrete Euler-Poincare equations, step after step: what one step computes about the
// equation is reused in the next.
//
// The functions `step_euler_poincare_right` and `step_euler_poincare_left` are given the last relative
// motion alone. A run of many steps has more: the momentum, which Ad* transports (the discrete Lie-Poisson
// algorithm); the derivative of the equation, which changes little from step to step; and an extrapolation of
// the motion. The relative motions are the same to rounding.
#pragma once

#include "actio/groups/predictor_corrector.hpp"
#include "actio/reduction/discrete_lie_poisson.hpp"

namespace actio {

/// The motion of an invariant system: the momentum equation solved step after step, with the momentum that
/// \f$\mathrm{Ad}^*\f$ transports, so that its coadjoint orbit is preserved to rounding.
///
/// Relative motions are those of \ref step_euler_poincare_right or \ref step_euler_poincare_left to rounding;
/// what a step costs is measured on \ref performance.
/// @tparam Invariance  \ref RightInvariant or \ref LeftInvariant
/// @tparam F           reduced discrete Lagrangian, \f$G\to\mathbb R\f$, energy x time
template <class Invariance, class F, ExponentialGroup G, Real S>
class EulerPoincareSteps {
 public:
  /// @param l  callable at every scalar
  /// @param f  relative motion over the step before the first
  EulerPoincareSteps(F l, Element<G, S> const& f)
      : l_(std::move(l)), motion_(f), momentum_(Invariance::momentum_after(l_, f)), solver_(f) {}

  /// Takes a step.
  /// @return the next relative motion
  /// @throws NotConverged, Singular  where the step is too long for the discrete Lagrangian to be regular;
  /// the motion stays where it was
  Element<G, S> const& advance() {
    motion_ = solver_.solve(Invariance::momentum_equation(l_, momentum_), motion_);
    momentum_ = Invariance::lie_poisson_update(motion_, momentum_);
    return motion_;
  }
  /// The relative motion over the last step.
  Element<G, S> const& relative_motion() const { return motion_; }
  /// The momentum after the last step, spatial (right-invariant) or of the body (left-invariant).
  Momentum<G, S> const& momentum() const { return momentum_; }
  /// How the last step was solved for.
  Report const& report() const { return solver_.report(); }

 private:
  F l_;
  Element<G, S> motion_;
  Momentum<G, S> momentum_;
  PredictorCorrector<G, S> solver_;
};

/// The motion of a right-invariant system: \ref euler_poincare_right solved step after step.
template <class F, ExponentialGroup G, Real S>
struct EulerPoincareStepsRight : EulerPoincareSteps<RightInvariant, F, G, S> {
  /// @param l    reduced discrete Lagrangian, callable at every scalar
  /// @param f01  relative motion \f$g_0g_1^{-1}\f$ over the step before the first
  /// @throws NotFinite  where f01 is no number, or l or its derivative there
  EulerPoincareStepsRight(F l, Element<G, S> const& f01)
      : EulerPoincareStepsRight::EulerPoincareSteps(std::move(l), f01) {}
};
/// The motion of a left-invariant system: \ref euler_poincare_left solved step after step.
///
/// \snippet reduction.cpp euler_poincare_steps
template <class F, ExponentialGroup G, Real S>
struct EulerPoincareStepsLeft : EulerPoincareSteps<LeftInvariant, F, G, S> {
  /// @param l    reduced discrete Lagrangian, callable at every scalar
  /// @param f10  relative motion \f$g_1^{-1}g_0\f$ over the step before the first
  /// @throws NotFinite  where f10 is no number, or l or its derivative there
  EulerPoincareStepsLeft(F l, Element<G, S> const& f10)
      : EulerPoincareStepsLeft::EulerPoincareSteps(std::move(l), f10) {}
};

}  // namespace actio
