// Runs on a level of the momentum, for a system given at run time: momenta, carried vectors, and
// configurations where they are asked for.
#pragma once

#include <Eigen/Core>

#include <memory>
#include <span>

#include "actio/any_group/chart_solver.hpp"
#include "actio/any_group/tape_lagrangian.hpp"

namespace actio::systems {

namespace detail {
/// What moves momentum and vectors by a step, compiled for columns of one length.
class LevelStep {
 public:
  virtual ~LevelStep() = default;
  virtual std::unique_ptr<LevelStep> copy() const = 0;
  /// @param velocity  near that of the momentum, before and after
  /// @param turn      the displacement of the group in the natural chart
  /// @return          how often a differential of the Lagrangian was evaluated
  virtual int advance(double h, ReducedPoint& point, std::vector<double>& velocity,
                      std::vector<double>& turn) = 0;
  /// What a step leaves to the next one.
  virtual std::vector<double> memory() = 0;
  virtual void recall(std::vector<double> memory) = 0;
};
}  // namespace detail

/// Steps of one length of \ref actio::advected_momentum_level_step_left, or its counterpart on the right:
/// explicit, of order 8. For one thread at a time.
class LevelIntegrator {
 public:
  /// @param system    of which the run is
  /// @param h         step, time
  /// @param start     momentum and vectors
  /// @param velocity  near which the first step looks for its own
  ///
  /// @throws OutsideDomain  with a force, and with friction other than damping along the free motion
  LevelIntegrator(std::shared_ptr<ReducedSystem const> system, double h, ReducedPoint start,
                  std::vector<double> const& velocity);
  /// Goes on from where the other one is, independently of it.
  LevelIntegrator(LevelIntegrator const& other);
  /// Takes the place of the other one.
  LevelIntegrator& operator=(LevelIntegrator&&) = default;

  /// Reconstructs configurations from this one on.
  void follow_configuration(Eigen::MatrixXd g) { configuration_ = std::move(g); }

  /// A step.
  /// @throws NotConverged, Singular, NotFinite, OutsideDomain where it has no solution; all is then as it was
  void step();

  ReducedPoint const& point() const { return point_; }  ///< momentum and vectors
  /// empty where it is not followed
  Eigen::MatrixXd const& configuration() const { return configuration_; }
  /// near the end of the last step
  std::vector<double> const& velocity() const { return velocity_; }
  /// How often a differential of the Lagrangian was evaluated.
  long evaluations() const { return evaluations_; }

  /// Saves, or restores, all that the next step depends on.
  template <class Stream>
  void remember(Stream& stream) {
    std::span<double> g(configuration_.data(), static_cast<std::size_t>(configuration_.size()));
    std::vector<double> memory = level_->memory();
    stream(point_.momentum, point_.vectors, velocity_, g, memory);
    level_->recall(std::move(memory));
  }

 private:
  std::shared_ptr<ReducedSystem const> system_;
  double length_, decay_;  // of the free motion; of the momentum
  std::unique_ptr<detail::LevelStep> level_;
  ReducedPoint point_;
  std::vector<double> velocity_, turn_;
  Eigen::MatrixXd configuration_;
  long evaluations_ = 0;
};

}  // namespace actio::systems
