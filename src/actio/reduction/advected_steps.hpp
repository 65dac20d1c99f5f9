// Motions by the discrete Euler-Poincare equations with an advected vector, step after step.
#pragma once

#include "actio/groups/predictor_corrector.hpp"
#include "actio/reduction/advected.hpp"

namespace actio {

/// The motion of a left-invariant system with an advected vector: \ref advected_euler_poincare_left solved
/// step after step.
///
/// Relative motions and vectors are those of \ref step_advected_euler_poincare_left and \ref advect_left to
/// rounding, in a fraction of the time. Momentum and vector are updated by \ref
/// advected_lie_poisson_update_left, so their coadjoint orbit is preserved to rounding.
/// @tparam F  reduced discrete Lagrangian (f, a) -> energy x time, a the vector before the step
template <class F, ExponentialGroup G, Real S, int m, class Act = MatrixAction>
class AdvectedStepsLeft {
 public:
  /// @param l    callable at every scalar
  /// @param f10  relative motion \f$g_1^{-1}g_0\f$ over the step before the first
  /// @param a0   the vector at \f$g_0\f$
  /// @param act  the action of G on vectors; multiplication by the matrix unless given
  /// @throws NotFinite  where f10 or a0 is no number, or l or its derivative there
  AdvectedStepsLeft(F l, Element<G, S> const& f10, Matrix<S, m, 1> const& a0, Act act = {})
      : l_(std::move(l)),
        act_(std::move(act)),
        motion_(f10),
        momentum_(advected_momentum_after_left(l_, f10, a0)),
        vector_(advect_left(f10, a0, act_)),
        solver_(f10) {
    require_finite(a0, "AdvectedStepsLeft: vector");
  }

  /// Takes a step: solves \f$\Pi_0(f, a) = \Pi\f$ and updates momentum and vector.
  /// @return the next relative motion
  /// @throws NotConverged, Singular  where the step is too long for the discrete Lagrangian to be regular;
  /// the motion stays where it was
  Element<G, S> const& advance() {
    Element<G, S> const f = solver_.solve(
        [&](auto const& x) {
          using T = typename std::decay_t<decltype(x)>::Scalar;
          return advected_momentum_before_left(l_, x, Matrix<T, m, 1>(vector_.template cast<T>()), act_) -
                 like(x, momentum_);
        },
        motion_);
    momentum_ = advected_lie_poisson_update_left(l_, f, vector_, momentum_, act_);
    vector_ = advect_left(f, vector_, act_);
    return motion_ = f;
  }
  /// The relative motion over the last step.
  Element<G, S> const& relative_motion() const { return motion_; }
  /// Body momentum and vector after the last step.
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

/// The motion of a right-invariant system with an advected vector: \ref advected_euler_poincare_right solved
/// step after step, with \ref advect_right. Otherwise as \ref AdvectedStepsLeft.
template <class F, ExponentialGroup G, Real S, int m, class Act = MatrixAction>
class AdvectedStepsRight {
 public:
  /// @param l    callable at every scalar
  /// @param f01  relative motion \f$g_0g_1^{-1}\f$ over the step before the first
  /// @param a0   the vector at \f$g_0\f$
  /// @param act  the action of G on vectors; multiplication by the matrix unless given
  /// @throws NotFinite  where f01 or a0 is no number, or l or its derivative there
  AdvectedStepsRight(F l, Element<G, S> const& f01, Matrix<S, m, 1> const& a0, Act act = {})
      : l_(std::move(l)),
        act_(std::move(act)),
        motion_(f01),
        momentum_(advected_momentum_after_right(l_, f01, a0)),
        vector_(advect_right(f01, a0, act_)),
        solver_(f01) {
    require_finite(a0, "AdvectedStepsRight: vector");
  }

  /// Takes a step: solves \f$\mu_0(f, a) = \mu\f$ and updates momentum and vector.
  /// @return the next relative motion
  /// @throws NotConverged, Singular  where the step is too long for the discrete Lagrangian to be regular;
  /// the motion stays where it was
  Element<G, S> const& advance() {
    Element<G, S> const f = solver_.solve(
        [&](auto const& x) {
          using T = typename std::decay_t<decltype(x)>::Scalar;
          return advected_momentum_before_right(l_, x, Matrix<T, m, 1>(vector_.template cast<T>()), act_) -
                 like(x, momentum_);
        },
        motion_);
    momentum_ = advected_lie_poisson_update_right(l_, f, vector_, momentum_, act_);
    vector_ = advect_right(f, vector_, act_);
    return motion_ = f;
  }
  /// The relative motion over the last step.
  Element<G, S> const& relative_motion() const { return motion_; }
  /// Spatial momentum and vector after the last step.
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

}  // namespace actio
