// Runs of systems with constraints on their velocity: momenta, carried vectors, reactions, and configurations
// where they are asked for.
#pragma once

#include <Eigen/Core>

#include <memory>

#include "actio/any_group/chart_integrator.hpp"
#include "actio/nonholonomic/rattle_solver.hpp"

namespace actio::systems {

/// A state that obeys constraints.
struct ConstrainedState {
  ReducedPoint point;            ///< momentum and vectors
  std::vector<double> velocity;  ///< \f$\partial l/\partial v\f$ of it is the momentum
  double moved;                  ///< how far the velocity that was given broke the constraints, relative
};

/// The state with a velocity, moved on the constraints as a blow does that makes a body roll.
///
/// @param v        velocity, 1/time
/// @param a        vectors
/// @param t        time
/// @param allowed  how far the velocity may break a constraint, relative to the terms of the constraint
/// @throws OutsideDomain  where it is further off
/// @throws Singular       where rows depend on each other, with the number of the row
/// @throws NotFinite      where a number is none, or a formula has no value there
ConstrainedState constrained_state(ReducedSystem const& system, VelocityConstraints const& constraints,
                                   std::vector<double> const& v, std::vector<double> const& a, double t = 0,
                                   double allowed = 1e-6);

/// Steps of one length, each of some substeps. For one thread at a time.
///
/// \snippet nonholonomic.cpp rattle_integrator
class RattleIntegrator {
 public:
  /// @param system       of which the run is
  /// @param constraints  of its velocity
  /// @param h            step, time
  /// @param fractions    of the substeps (composition.hpp); {1} for order 2, five of `suzuki()` for order 4
  /// @param start        obeys the constraints
  /// @param t            time at the start
  RattleIntegrator(std::shared_ptr<ReducedSystem const> system,
                   std::shared_ptr<VelocityConstraints const> constraints, double h,
                   std::vector<double> const& fractions, ConstrainedState const& start, double t = 0);

  /// Reconstructs configurations from this one on.
  void follow_configuration(Eigen::MatrixXd g) { configuration_ = std::move(g); }

  /// A whole step.
  /// @throws NotConverged, Singular, NotFinite  where a substep has no solution; all is then as it was
  void step();

  double time() const { return start_ + static_cast<double>(steps_) * h_; }  ///< now
  /// Momentum before the reactions of the next step, up to a combination of the rows; and vectors.
  ReducedPoint const& point() const { return point_; }
  /// Momentum and velocity that obey the constraints, vectors.
  /// @throws NotConverged, Singular, NotFinite  where the Lagrangian is not regular along the constraints
  ConstrainedState state() const;
  /// The reactions, force along each row: as accurate as the state.
  std::vector<double> reaction() const;
  /// empty where it is not followed
  Eigen::MatrixXd const& configuration() const { return configuration_; }
  /// of the last substep
  std::vector<double> velocity_of_substep() const;
  /// The multipliers at the start of the last substep: the impulse of the reactions there, half of it from
  /// the substep before.
  std::vector<double> impulse() const;
  /// How often momenta were evaluated.
  long evaluations() const {
    long sum = 0;
    for (auto const& substep : substeps_) sum += substep.evaluations();
    return sum;
  }

  /// Saves, or restores, all that the next step depends on.
  template <class Stream>
  void remember(Stream& stream) {
    stream(start_, steps_, point_.momentum, point_.vectors);
    std::span<double> g(configuration_.data(), static_cast<std::size_t>(configuration_.size()));
    stream(g);
    for (auto& substep : substeps_) substep.remember(stream);
  }

 private:
  std::shared_ptr<ReducedSystem const> system_;
  std::shared_ptr<VelocityConstraints const> constraints_;
  std::vector<RattleSolver> substeps_;
  double h_, start_;
  long steps_ = 0;
  ReducedPoint point_, point_before_;
  Eigen::MatrixXd configuration_, configuration_before_;
};

}  // namespace actio::systems
