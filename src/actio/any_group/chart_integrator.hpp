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

/// What the forces have done since the start.
struct ForceLedger {
  double work = 0;  ///< \f$\sum\tfrac h2\langle F_k + F_{k+1}, v\rangle\f$, energy
  /// \f$\sum\tfrac h2(\mathrm{Ad}^*_{g_k^{-1}}F_k + \mathrm{Ad}^*_{g_{k+1}^{-1}}F_{k+1})\f$, energy x time:
  /// by as much the momentum of the symmetry has changed; on the right with g for its inverse. Empty where
  /// configurations are not followed, or there is no force.
  std::vector<double> impulse = {};
};

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
  void follow_configuration(Eigen::MatrixXd g) {
    configuration_ = std::move(g);
    if (system_->force) ledger_.impulse.resize(point_.momentum.size());
  }

  /// A whole step.
  /// @throws NotConverged, Singular, NotFinite  where a substep has no solution; all is then as it was
  void step();

  ReducedPoint const& point() const { return point_; }  ///< momentum and vectors
  /// The forces on the system, summed over the steps: zero where there are none.
  ForceLedger const& ledger() const { return ledger_; }
  /// Adds what the forces have done before.
  void add_before(ForceLedger const& before);
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
    if (!point_.frame.empty()) stream(point_.frame);
    if (system_->force) stream(begin_, steps_, ledger_.work, ledger_.impulse), set_time();
    std::span<double> g(configuration_.data(), static_cast<std::size_t>(configuration_.size()));
    stream(g);
    for (auto& substep : substeps_) substep.remember(stream);
  }

 private:
  /// The friction for a time; nothing where there is none.
  void dissipate(double h, ChartSolver const& substep);
  /// Adds (h/2) Ad* of a force at the configuration to the impulse.
  void add_impulse(double h, std::vector<double> const& force);
  /// The time at the end of all steps so far, without the rounding of their sum.
  void set_time() { point_.time = begin_ + static_cast<double>(steps_) * length_; }

  std::shared_ptr<ReducedSystem const> system_;
  std::vector<ChartSolver> substeps_;
  double length_, begin_;
  bool along_free_motion_ = false;  // a damped motion
  long steps_ = 0;
  ReducedPoint point_, point_before_;
  ForceLedger ledger_;
  Eigen::MatrixXd configuration_, configuration_before_;
};

}  // namespace actio::systems
