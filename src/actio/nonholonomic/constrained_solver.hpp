// Velocity and multipliers of a step with constraints, step after step.
//
// Steps differ in where the reactions act and in what momenta are at the ends. What is solved is one
// equation,
//
//     before(v) = mu + s A^T lambda,      c(v) = 0,
//
// with the momentum mu at the start, and the share s of the reactions that comes before the middle.
#pragma once

#include "actio/any_group/chart_solver.hpp"
#include "actio/nonholonomic/conserving_step.hpp"
#include "actio/nonholonomic/constrained_velocity.hpp"
#include "actio/nonholonomic/rattle_step.hpp"

namespace actio::systems {

/// Sets the residual of the equation of a step that was evaluated, momenta before constraints.
/// @param momentum  at the start
/// @param x         velocity and multipliers
template <class Step, class S>
void set_residual(Step const& step, std::vector<S> const& momentum, std::vector<S> const& x,
                  std::vector<S>& residual) {
  auto const d = momentum.size(), n = x.size();
  for (std::size_t i = 0; i < d; ++i) {
    residual[i] = step.before()[i] - momentum[i];
    for (std::size_t k = 0; k + d < n; ++k)
      residual[i] -= S(Step::share) * step.constraint.rows[k * d + i] * x[d + k];
  }
  for (std::size_t k = 0; k + d < n; ++k) residual[d + k] = step.constraint.values[k];
}

/// Solves for steps of one length, as \ref ChartSolver does without constraints. For one thread at a time.
/// @tparam Step  \ref RattleStep, or \ref ConservingStep
template <template <class> class Step>
class ConstrainedSolver {
 public:
  /// Of a system and constraints that outlive it.
  /// @param h  step, time; of either sign
  /// @throws OutsideDomain  where such steps cannot take the system
  ConstrainedSolver(ReducedSystem const& system, VelocityConstraints const& constraints, double h);

  double length() const { return h_; }  ///< of a step
  /// Of the last step: the velocity, then the multipliers, impulses along the rows: at its start, or in the
  /// middle of steps that conserve the energy.
  std::vector<double> const& unknowns() const { return iteration_.unknowns; }
  /// The velocity among them.
  std::vector<double> velocity() const {
    return {iteration_.unknowns.begin(), iteration_.unknowns.begin() + constraints_.dimension};
  }
  /// The multipliers among them.
  std::vector<double> multipliers() const {
    return {iteration_.unknowns.begin() + constraints_.dimension, iteration_.unknowns.end()};
  }
  /// The last step, with its constraints and their rows.
  Step<double> const& last() const { return step_; }
  /// How often the equations were evaluated, one batch of derivatives counting as one.
  long evaluations() const { return evaluations_; }

  /// Takes a step from a time: sets the point to that at its end. By rattle its momentum is \f$P_1\f$, which
  /// does not obey the constraints yet: the reactions of the next step are to come. Any combination of the
  /// rows at the point may be added to its momentum.
  /// @throws NotConverged, Singular, NotFinite  where there is no such step near by; the point is as it was
  /// @throws OutsideDomain  where the step would turn by half a turn or more, beyond the chart
  void operator()(ReducedPoint& point, double t);

  /// The inverse of the derivative of the equations in velocity and multipliers, at the last solution.
  Eigen::MatrixXd exact_inverse(ReducedPoint const& start, double t);

  /// Where the first step looks for its velocity.
  void begin_at(std::vector<double> const& velocity);
  /// Saves, or restores, all that the next step depends on.
  template <class Stream>
  void remember(Stream& stream) {
    stream(evaluations_);
    iteration_.store(stream);
    history_.store(stream, iteration_.unknowns.size());
  }

 private:
  /// The residual at the unknowns, and its size: of momenta relative to what they are sums of, of a
  /// constraint relative to what it is of a velocity of this size.
  double evaluate(ReducedPoint const& start, double t);
  bool differentiate(ReducedPoint const& start, double t);
  void newton(ReducedPoint const& start, double t);

  VelocityConstraints const& constraints_;
  double h_;
  Step<double> step_;
  Step<Moved<double>> moved_;
  ConstrainedVelocity projection_;
  StepIteration iteration_;
  SolutionHistory history_;
  std::vector<double> v_;
  long evaluations_ = 0;
  double regular_ = 1;
};

extern template class ConstrainedSolver<RattleStep>;
extern template class ConstrainedSolver<ConservingStep>;
using RattleSolver = ConstrainedSolver<RattleStep>;          ///< of the discrete principle
using ConservingSolver = ConstrainedSolver<ConservingStep>;  ///< of steps that conserve the energy

}  // namespace actio::systems
