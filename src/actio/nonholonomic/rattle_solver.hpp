// Velocity and multipliers of a step with constraints, step after step.
#pragma once

#include "actio/any_group/chart_solver.hpp"
#include "actio/nonholonomic/constrained_velocity.hpp"
#include "actio/nonholonomic/rattle_step.hpp"

namespace actio::systems {

/// Solves for steps of one length, as \ref ChartSolver does without constraints. For one thread at a time.
class RattleSolver {
 public:
  /// Of a system and constraints that outlive it.
  /// @param h  step, time; of either sign
  RattleSolver(ReducedSystem const& system, VelocityConstraints const& constraints, double h);

  double length() const { return h_; }  ///< of a step
  /// Of the last step: the velocity, then the multipliers at its start.
  std::vector<double> const& unknowns() const { return iteration_.unknowns; }
  /// How often momenta were evaluated, one batch of derivatives counting as one.
  long evaluations() const { return evaluations_; }

  /// Takes a step from a time: sets the point to that at its end. Its momentum is \f$P_1\f$, which does not
  /// obey the constraints yet: the reactions of the next step are to come. Any combination of the rows at the
  /// point may be added to its momentum.
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
  double evaluate(ReducedPoint const& start, double t);
  bool differentiate(ReducedPoint const& start, double t);
  void newton(ReducedPoint const& start, double t);
  std::size_t dimension() const { return static_cast<std::size_t>(constraints_.dimension); }

  ReducedSystem const& system_;
  VelocityConstraints const& constraints_;
  double h_;
  RattleStep<double> step_;
  RattleStep<Moved<double>> moved_;
  ConstraintValues<double> start_;
  ConstrainedVelocity projection_;
  StepIteration iteration_;
  SolutionHistory history_;
  std::vector<double> v_;
  long evaluations_ = 0;
  double regular_ = 1;
};

}  // namespace actio::systems
