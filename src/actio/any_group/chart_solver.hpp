// The velocity of a step of the natural chart from the momentum at its start, step after step.
//
// The equation P_0(v) = P of one step differs little from that of the step before. The inverse of its
// derivative is reused and improved by Broyden's formula, and the first guess is extrapolated from the last
// velocities, by the polynomial that would have been best for the one before. Where that fails Newton's
// iteration begins at the Legendre velocity.
#pragma once

#include <Eigen/Core>

#include "actio/any_group/chart_step.hpp"
#include "actio/any_group/eigenvalues_of.hpp"
#include "actio/any_group/legendre_velocity.hpp"
#include "actio/any_group/solution_history.hpp"
#include "actio/any_group/step_iteration.hpp"

namespace actio::systems {

/// Momentum and carried vectors of a system at one time.
struct ReducedPoint {
  std::vector<double> momentum,  ///< of the body (left-invariant) or in space (right-invariant)
      vectors;                   ///< one after the other
  double time = 0;               ///< when, for a force that depends on it
  /// how covectors of the other side are moved to this one, for a force that has their components: `frame_at`
  std::vector<double> frame = {};
};

/// The force on a system at a point with a velocity, with the inputs of that time.
/// @throws OutsideDomain  where it has components of the other side, and the point no frame
std::vector<double> force_at(ReducedSystem const& system, std::vector<double> const& v,
                             ReducedPoint const& at);

/// Refuses a step that turns by half a turn or more, beyond the chart: no eigenvalue of
/// \f$h\,\mathrm{ad}_v\f$ has an imaginary part of pi or more. Its trace tells where that is beyond question.
/// @param step  as it was last called, with the step h and the velocity v
/// @throws OutsideDomain
void require_in_chart(ReducedSystem const& system, ChartStep<double> const& step, double h,
                      std::vector<double> const& v);

/// Solves for steps of one length. For one thread at a time; what it has found out is part of the state of a
/// run, since the digits depend on it.
class ChartSolver {
 public:
  /// Of a system that outlives it.
  /// @param h  step, time; of either sign
  ChartSolver(ReducedSystem const& system, double h);

  double length() const { return h_; }  ///< of a step
  /// The last step, with the forces at its ends.
  ChartStep<double> const& last() const { return step_; }
  std::vector<double> const& velocity() const { return iteration_.unknowns; }  ///< of the last step
  /// How often momenta were evaluated, one batch of derivatives counting as one.
  long evaluations() const { return evaluations_; }

  /// Takes a step: sets the point to that at its end.
  /// @throws NotConverged, Singular, NotFinite  where there is no such step near by; the point is as it was
  /// @throws OutsideDomain  where the step would turn by half a turn or more, beyond the chart
  void operator()(ReducedPoint& point);

  /// The inverse of the derivative of the momentum at the start in the velocity, at the last solution.
  Eigen::MatrixXd exact_inverse(ReducedPoint const& start) {
    differentiate(start);
    auto const d = system_.dimension();
    return Eigen::Map<Eigen::Matrix<double, -1, -1, Eigen::RowMajor> const>(iteration_.inverse.data(), d, d);
  }

  /// Where the first step looks for its velocity.
  void begin_at(std::vector<double> velocity) {
    iteration_.unknowns = std::move(velocity), iteration_.forget(), history_.clear();
  }
  /// Saves, or restores, all that the next step depends on.
  template <class Stream>
  void remember(Stream& stream) {
    stream(evaluations_);
    iteration_.store(stream);
    history_.store(stream, velocity().size());
  }

 private:
  /// The residual at the velocity, and its size: in each component relative to what it is the sum of. The
  /// parts of ad* p are among these: for two equal moments they cancel, and so do their derivatives.
  /// Infinite outside of the chart. It is minus the momentum equation of (3.10) or (3.11), by structure
  /// constants.
  double evaluate(ReducedPoint const& start);

  /// The inverse of the derivative at the velocity; the residual is left alone.
  bool differentiate(ReducedPoint const& start);

  /// Newton's iteration from the Legendre velocity.
  /// @throws NotConverged, Singular
  void newton(ReducedPoint const& start);

  ReducedSystem const& system_;
  double h_;
  ChartStep<double> step_;
  ChartStep<Moved<double>> moved_;
  LegendreVelocity legendre_;
  StepIteration iteration_;
  SolutionHistory history_;
  long evaluations_ = 0;
  double regular_ = 1;
};

}  // namespace actio::systems
