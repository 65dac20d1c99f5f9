// Motions by the discrete Euler-Poincare equations with an advected vector, step after step.
#pragma once

#include "actio/groups/predictor_corrector.hpp"
#include "actio/reduction/advected.hpp"

namespace actio {

namespace detail {
/// The equations of right-invariant systems with an advected vector, for what is written once for both sides.
struct AdvectedRight {
  static auto momentum_after(auto const&... x) { return advected_momentum_after_right(x...); }
  static auto momentum_equation(auto const&... x) { return advected_momentum_equation_right(x...); }
  static auto lie_poisson_update(auto const&... x) { return advected_lie_poisson_update_right(x...); }
  static auto advect(auto const&... x) { return advect_right(x...); }
};
/// The equations of left-invariant systems with an advected vector.
struct AdvectedLeft {
  static auto momentum_after(auto const&... x) { return advected_momentum_after_left(x...); }
  static auto momentum_equation(auto const&... x) { return advected_momentum_equation_left(x...); }
  static auto lie_poisson_update(auto const&... x) { return advected_lie_poisson_update_left(x...); }
  static auto advect(auto const&... x) { return advect_left(x...); }
};
}  // namespace detail

/// The motion of an invariant system with an advected vector, on one of two sides: \ref AdvectedStepsLeft and
/// \ref AdvectedStepsRight.
///
/// Relative motions and vectors are those of \ref step_advected_euler_poincare_left or \ref
/// step_advected_euler_poincare_right to rounding, in a fraction of the time. Momentum and vector move on
/// their coadjoint orbit, which is preserved to rounding.
template <class Invariance, class F, ExponentialGroup G, Real S, int m, class Act>
class AdvectedSteps {
 public:
  /// @param l    reduced discrete Lagrangian (f, a) -> energy x time, callable at every scalar
  /// @param f    relative motion over the step before the first
  /// @param a0   the vector at the start of that step
  /// @param act  the action of G on vectors
  AdvectedSteps(F l, Element<G, S> const& f, Matrix<S, m, 1> const& a0, Act act)
      : l_(std::move(l)),
        act_(std::move(act)),
        motion_(f),
        momentum_(Invariance::momentum_after(l_, f, a0)),
        vector_(Invariance::advect(f, a0, act_)),
        solver_(f) {
    require_finite(a0, "AdvectedSteps: vector");
  }

  /// Takes a step: solves for the relative motion and updates momentum and vector.
  /// @return the next relative motion
  /// @throws NotConverged, Singular  where the step is too long for the discrete Lagrangian to be regular;
  /// the motion stays where it was
  Element<G, S> const& advance() {
    auto const f = solver_.solve(Invariance::momentum_equation(l_, momentum_, vector_, act_), motion_);
    momentum_ = Invariance::lie_poisson_update(l_, f, vector_, momentum_, act_);
    vector_ = Invariance::advect(f, vector_, act_);
    return motion_ = f;
  }
  /// The relative motion over the last step.
  Element<G, S> const& relative_motion() const { return motion_; }
  /// Momentum, of the body (left-invariant) or spatial (right-invariant), and vector after the last step.
  AdvectedState<G, S, m> state() const { return {momentum_, vector_}; }
  /// How the last step was solved for.
  Report const& report() const { return solver_.report(); }

 private:
  F l_;
  [[no_unique_address]] Act act_;
  Element<G, S> motion_;
  Momentum<G, S> momentum_;
  Matrix<S, m, 1> vector_;
  PredictorCorrector<G, S> solver_;
};

/// The motion of a left-invariant system with an advected vector: \ref advected_euler_poincare_left solved
/// step after step, with \ref advect_left.
template <class F, ExponentialGroup G, Real S, int m, class Act = MatrixAction>
struct AdvectedStepsLeft : AdvectedSteps<detail::AdvectedLeft, F, G, S, m, Act> {
  /// @throws NotFinite  where f10 or a0 is no number, or l or its derivative there
  AdvectedStepsLeft(F l, Element<G, S> const& f10, Matrix<S, m, 1> const& a0, Act act = {})
      : AdvectedStepsLeft::AdvectedSteps(std::move(l), f10, a0, std::move(act)) {}
};
/// The motion of a right-invariant system with an advected vector: \ref advected_euler_poincare_right solved
/// step after step, with \ref advect_right.
template <class F, ExponentialGroup G, Real S, int m, class Act = MatrixAction>
struct AdvectedStepsRight : AdvectedSteps<detail::AdvectedRight, F, G, S, m, Act> {
  /// @throws NotFinite  where f01 or a0 is no number, or l or its derivative there
  AdvectedStepsRight(F l, Element<G, S> const& f01, Matrix<S, m, 1> const& a0, Act act = {})
      : AdvectedStepsRight::AdvectedSteps(std::move(l), f01, a0, std::move(act)) {}
};

}  // namespace actio
