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

/// The motion of a right-invariant system: \ref euler_poincare_right solved step after step.
///
/// Relative motions are those of \ref step_euler_poincare_right to rounding; what a step costs is measured on
/// \ref performance. The momentum is transported by \f$\mathrm{Ad}^*\f$, so its coadjoint orbit is preserved
/// to rounding.
/// @tparam F  reduced discrete Lagrangian, \f$G\to\mathbb R\f$, energy x time
template <class F, ExponentialGroup G, Real S>
class EulerPoincareStepsRight {
 public:
  /// @param l    reduced discrete Lagrangian, callable at every scalar
  /// @param f01  relative motion \f$g_0g_1^{-1}\f$ over the step before the first
  /// @throws NotFinite  where f01 is no number, or l or its derivative there
  EulerPoincareStepsRight(F l, Element<G, S> const& f01)
      : l_(std::move(l)), motion_(f01), end_momentum_(-left_differential(l_, f01)), solver_(f01) {}

  /// Takes a step: solves \f$R_f^*\ell'(f) = L_{f_{01}}^*\ell'(f_{01})\f$.
  /// @return the next relative motion
  /// @throws NotConverged, Singular  where the step is too long for the discrete Lagrangian to be regular;
  /// the motion stays where it was
  Element<G, S> const& advance() {
    motion_ = solver_.solve([&](auto const& f) { return right_differential(l_, f) + like(f, end_momentum_); },
                            motion_);
    end_momentum_ = lie_poisson_update_right(motion_, end_momentum_);
    return motion_;
  }
  /// The relative motion over the last step.
  Element<G, S> const& relative_motion() const { return motion_; }
  /// \f$\mu_1 = -L_f^*\ell'(f)\f$: the spatial momentum after the last step.
  Momentum<G, S> const& momentum() const { return end_momentum_; }
  /// How the last step was solved for.
  Report const& report() const { return solver_.report(); }

 private:
  F l_;
  Element<G, S> motion_;
  Momentum<G, S> end_momentum_;
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
      : l_(std::move(l)), motion_(f10), end_momentum_(-right_differential(l_, f10)), solver_(f10) {}

  /// Takes a step: solves \f$L_f^*\ell'(f) = R_{f_{10}}^*\ell'(f_{10})\f$.
  /// @return the next relative motion
  /// @throws NotConverged, Singular  where the step is too long for the discrete Lagrangian to be regular;
  /// the motion stays where it was
  Element<G, S> const& advance() {
    motion_ = solver_.solve([&](auto const& f) { return left_differential(l_, f) + like(f, end_momentum_); },
                            motion_);
    end_momentum_ = lie_poisson_update_left(motion_, end_momentum_);
    return motion_;
  }
  /// The relative motion over the last step.
  Element<G, S> const& relative_motion() const { return motion_; }
  /// \f$\Pi_1 = -R_f^*\ell'(f)\f$: the body momentum after the last step.
  Momentum<G, S> const& momentum() const { return end_momentum_; }
  /// How the last step was solved for.
  Report const& report() const { return solver_.report(); }

 private:
  F l_;
  Element<G, S> motion_;
  Momentum<G, S> end_momentum_;
  PredictorCorrector<G, S> solver_;
};

}  // namespace actio
