// Runs of systems with constraints on their velocity that conserve the energy.
#pragma once

#include <memory>

#include "actio/nonholonomic/conserving_step.hpp"
#include "actio/nonholonomic/rattle_integrator.hpp"

namespace actio::systems {

/// Solves for steps of one length, \ref ConservingStep. For one thread at a time.
class ConservingSolver {
 public:
  /// Of a system and constraints that outlive it.
  /// @param h  step, time; of either sign
  /// @throws OutsideDomain  where the chart is not Cayley's, or the Lagrangian is not
  ///                        \f$\tfrac12v\cdot Mv - V(a)\f$ with a constant M, as it is written
  ConservingSolver(ReducedSystem const& system, VelocityConstraints const& constraints, double h);

  double length() const { return h_; }  ///< of a step
  /// Of the last step: the velocity, then the multipliers in its middle.
  std::vector<double> const& unknowns() const { return iteration_.unknowns; }
  /// How often the equations were evaluated, one batch of derivatives counting as one.
  long evaluations() const { return evaluations_; }

  /// Takes a step from a time: sets the point to that at its end.
  /// @throws NotConverged, Singular, NotFinite  where there is no such step near by; the point is as it was
  void operator()(ReducedPoint& point, double t);

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

  VelocityConstraints const& constraints_;
  double h_;
  ConservingStep<double> step_;
  ConservingStep<Moved<double>> moved_;
  ConstrainedVelocity projection_;
  StepIteration iteration_;
  SolutionHistory history_;
  std::vector<double> v_, multipliers_;  // as they were evaluated last
  long evaluations_ = 0;
  double regular_ = 1;
};

}  // namespace actio::systems
