// How a system with a Lagrangian of one's own moves, as scenes step it.
#pragma once

#include <Eigen/Core>

#include <memory>
#include <optional>

#include "actio/any_group/chart_map.hpp"
#include "program/registry/simulation.hpp"
#include "program/systems/lagrangians/input.hpp"

namespace actio::scene {

/// A motion whose state is a momentum, carried vectors and, where it is followed, a configuration.
class ReducedMotion : public Motion {
 public:
  virtual systems::ReducedPoint const& point() const = 0;    ///< momentum and vectors now
  virtual Eigen::MatrixXd const& configuration() const = 0;  ///< now; empty where it is not followed
  virtual std::vector<double> const& velocity() const = 0;   ///< near the one now, for searches
  /// What the forces have done since the start.
  virtual systems::ForceLedger const& ledger() const;
  virtual double time() const { return 0; }                      ///< now, where the motion depends on it
  virtual std::vector<double> constraint() const { return {}; }  ///< the values of constraints
  /// So many steps; what fails is thrown as it is.
  virtual void advance_plainly(long steps) { advance(steps); }
  /// How momentum and vectors now change with those at the start; null where that is not followed.
  virtual Eigen::MatrixXd const* tangent() const { return nullptr; }
  /// That of the configurations is \f$\sqrt{n/2}\,|h - g|_F/|g|_F\f$: on rotations, for a small turn in
  /// one plane, that turn; on groups that are not compact it stays relative to the size of the entries.
  StateDistance distance(Motion const& other) const override;
};

/// What is stepped: the scheme, and from where.
struct ReducedScheme {
  std::shared_ptr<systems::ReducedSystem const> system;  ///< that is stepped
  int stages = 0;                                        ///< of Galerkin's method; 0: the natural chart
  /// of the substeps of the natural chart; none: steps on a level of the momentum
  std::vector<double> fractions;
  bool with_configuration = true;      ///< whether configurations are reconstructed
  std::string name = "natural chart";  ///< of the method, for messages
  /// of the velocity; null where there are none
  std::shared_ptr<systems::VelocityConstraints const> constraints = nullptr;
  bool keeps_energy = true;               ///< whether the motion does
  bool conserves = false;                 ///< whether steps with constraints conserve it to rounding
  bool with_ledger = false;               ///< whether what reactions do is summed up
  std::vector<std::string> carried = {};  ///< the names of the carried vectors

  /// Steps of a length from a state.
  /// @throws Error  where the first step cannot be made
  std::unique_ptr<ReducedMotion> motion(double step, systems::ReducedPoint const& start,
                                        std::vector<double> const& velocity,
                                        Eigen::MatrixXd const& configuration) const;
  /// A length of steps that can be made from a state, shorter than this one: eight of them, and eight that
  /// are shorter by a fifth, and by another. Zero where none is found.
  /// @param divisor  of the times of the rows, which the step divides; zero: any length
  double longest_step(double step, double divisor, systems::ReducedPoint const& start,
                      std::vector<double> const& velocity) const;
  /// Throws what says the longest step that would do where a step from a state fails; where none would, what
  /// it failed with.
  [[noreturn]] void fail(Error const& error, double step, systems::ReducedPoint const& start,
                         std::vector<double> const& velocity) const;
};

/// A motion that can take no step, and stays.
std::unique_ptr<ReducedMotion> standing(ReducedScene const& scene);

}  // namespace actio::scene
