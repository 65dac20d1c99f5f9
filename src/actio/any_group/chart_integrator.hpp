// Runs by the natural chart and its symmetric compositions, for a system given at run time: momenta, carried
// vectors, and configurations where they are asked for.
#pragma once

#include <Eigen/Core>

#include <memory>
#include <span>

#include "actio/any_group/chart_solver.hpp"

namespace actio::systems {

/// \f$e^{hv}\f$ applied to the columns of a matrix, by its series over the nonzero entries of the basis.
/// Accuracy: a few epsilon times \f$e^{|hv|}\f$.
void apply_exponential(MatrixAlgebra const& algebra, double h, std::vector<double> const& v,
                       Eigen::MatrixXd& g);

/// Moves a configuration by a step: \f$g\,e^{hv}\f$ (left-invariant), \f$e^{hv}g\f$ (right-invariant), or by
/// Cayley's transform of \f$hv\f$.
/// @param v  velocity, and whatever follows it in the list
void move_configuration(ReducedSystem const& system, double h, std::vector<double> const& v,
                        Eigen::MatrixXd& g);

/// Steps of one length, each of some substeps. For one thread at a time.
///
/// \snippet reduction.cpp chart_integrator
class ChartIntegrator {
 public:
  /// @param system     of which the run is
  /// @param h          step, time
  /// @param fractions  of the substeps (composition.hpp); {1} for order 2
  /// @param start      momentum and vectors
  /// @param velocity   near which the first step looks for its own
  ChartIntegrator(std::shared_ptr<ReducedSystem const> system, double h, std::vector<double> const& fractions,
                  ReducedPoint start, std::vector<double> const& velocity);

  /// Reconstructs configurations from this one on.
  void follow_configuration(Eigen::MatrixXd g) { configuration_ = std::move(g); }

  /// A whole step.
  /// @throws NotConverged, Singular, NotFinite  where a substep has no solution; all is then as it was
  void step();

  ReducedPoint const& point() const { return point_; }  ///< momentum and vectors
  /// empty where it is not followed
  Eigen::MatrixXd const& configuration() const { return configuration_; }
  /// of the last substep
  std::vector<double> const& velocity() const { return substeps_.back().velocity(); }
  /// How often momenta were evaluated.
  long evaluations() const {
    long sum = 0;
    for (auto const& substep : substeps_) sum += substep.evaluations();
    return sum;
  }

  /// Saves, or restores, all that the next step depends on.
  template <class Stream>
  void remember(Stream& stream) {
    stream(point_.momentum, point_.vectors);
    std::span<double> g(configuration_.data(), static_cast<std::size_t>(configuration_.size()));
    stream(g);
    for (auto& substep : substeps_) substep.remember(stream);
  }

 private:
  std::shared_ptr<ReducedSystem const> system_;
  std::vector<ChartSolver> substeps_;
  ReducedPoint point_, point_before_;
  Eigen::MatrixXd configuration_, configuration_before_;
};

}  // namespace actio::systems
