// Motions by the discrete Euler-Poincare equations, step after step: what one step has found out about the
// equation serves the next.
//
// The functions `step_euler_poincare_right` and `step_euler_poincare_left` know of a motion the last relative
// motion. Who takes many steps knows more: the momentum, which Ad* carries along (the discrete Lie-Poisson
// algorithm); the derivative of the equation, which changes little from step to step; and where the motion is
// going. The relative motions are the same to rounding.
#pragma once

#include "actio/groups/predictor_corrector.hpp"
#include "actio/reduction/discrete_lie_poisson.hpp"

namespace actio {

/// The motion of a right-invariant system: \ref euler_poincare_right solved step after step.
///
/// Relative motions are those of \ref step_euler_poincare_right to rounding; what a step costs is measured on \ref performance.
/// The momentum is carried along by \f$\mathrm{Ad}^*\f$, so its coadjoint orbit is kept to rounding.
/// @tparam F  reduced discrete Lagrangian, \f$G\to\mathbb R\f$, energy x time
template <class F, ExponentialGroup G, Real S>
class EulerPoincareStepsRight {
 public:
  /// @param l    reduced discrete Lagrangian, callable at every scalar
  /// @param f01  relative motion \f$g_0g_1^{-1}\f$ over the step before the first
  /// @throws NotFinite  where f01 is no number, or l or its derivative there
  EulerPoincareStepsRight(F l, Element<G, S> const& f01)
      : l_(std::move(l)), motion_(f01), left_behind_(left_differential(l_, f01)), solver_(f01) {}

  /// Takes a step: solves \f$R_f^*\ell'(f) = L_{f_{01}}^*\ell'(f_{01})\f$.
  /// @return the next relative motion
  /// @throws NotConverged, Singular  where the step is too long for the discrete Lagrangian to be regular;
  /// the motion stays where it was
  Element<G, S> const& advance() {
    motion_ = solver_.solve([&](auto const& f) { return right_differential(l_, f) - like(f, left_behind_); },
                            motion_);
    left_behind_ = lie_poisson_update_right(motion_, left_behind_);
    return motion_;
  }
  /// The relative motion over the last step.
  Element<G, S> const& relative_motion() const { return motion_; }
  /// \f$\mu_1 = -L_f^*\ell'(f)\f$: the spatial momentum after the last step.
  Momentum<G, S> momentum() const { return -left_behind_; }
  /// How the last step was solved for.
  Report const& report() const { return solver_.report(); }

 private:
  F l_;
  Element<G, S> motion_;
  Momentum<G, S> left_behind_;
  PredictorCorrector<G, S> solver_;
};

/// The motion of a left-invariant system: \ref euler_poincare_left solved step after step. Otherwise as \ref
/// EulerPoincareStepsRight.
template <class F, ExponentialGroup G, Real S>
class EulerPoincareStepsLeft {
 public:
  /// @param l    reduced discrete Lagrangian, callable at every scalar
  /// @param f10  relative motion \f$g_1^{-1}g_0\f$ over the step before the first
  /// @throws NotFinite  where f10 is no number, or l or its derivative there
  EulerPoincareStepsLeft(F l, Element<G, S> const& f10)
      : l_(std::move(l)), motion_(f10), left_behind_(right_differential(l_, f10)), solver_(f10) {}

  /// Takes a step: solves \f$L_f^*\ell'(f) = R_{f_{10}}^*\ell'(f_{10})\f$.
  /// @return the next relative motion
  /// @throws NotConverged, Singular  where the step is too long for the discrete Lagrangian to be regular;
  /// the motion stays where it was
  Element<G, S> const& advance() {
    motion_ = solver_.solve([&](auto const& f) { return left_differential(l_, f) - like(f, left_behind_); },
                            motion_);
    left_behind_ = lie_poisson_update_left(motion_, left_behind_);
    return motion_;
  }
  /// The relative motion over the last step.
  Element<G, S> const& relative_motion() const { return motion_; }
  /// \f$\Pi_1 = -R_f^*\ell'(f)\f$: the body momentum after the last step.
  Momentum<G, S> momentum() const { return -left_behind_; }
  /// How the last step was solved for.
  Report const& report() const { return solver_.report(); }

 private:
  F l_;
  Element<G, S> motion_;
  Momentum<G, S> left_behind_;
  PredictorCorrector<G, S> solver_;
};

}  // namespace actio
