// How a system with a Lagrangian of one's own moves, as scenes step it.
#pragma once

#include <memory>
#include <optional>

#include "actio/any_group/chart_map.hpp"
#include "actio/scene/simulation.hpp"
#include "actio/scene/systems/reduced_input.hpp"

namespace actio::scene {

/// A motion whose state is a momentum, carried vectors and, where it is followed, a configuration.
class ReducedMotion : public Motion {
 public:
  virtual ReducedPoint const& point() const = 0;             ///< momentum and vectors now
  virtual Eigen::MatrixXd const& configuration() const = 0;  ///< now; empty where it is not followed
  virtual std::vector<double> const& velocity() const = 0;   ///< near the one now, for searches
  /// How momentum and vectors now change with those at the start; null where that is not followed.
  virtual Eigen::MatrixXd const* tangent() const { return nullptr; }
  StateDistance distance(Motion const& other) const override;
};

/// What is stepped: the scheme, and from where.
struct ReducedScheme {
  std::shared_ptr<ReducedSystem const> system;
  int stages = 0;                 ///< of Galerkin's method; 0: the natural chart
  std::vector<double> fractions;  ///< of the substeps of the natural chart
  bool with_configuration = true;

  /// Steps of a length from a state.
  /// @throws Error  where the first step cannot be made
  std::unique_ptr<ReducedMotion> motion(double step, ReducedPoint const& start,
                                        std::vector<double> const& velocity,
                                        Eigen::MatrixXd const& configuration) const;
  /// The longest step that can be made from a state, at most this one, to three digits; zero where none can.
  double longest_step(double step, ReducedPoint const& start, std::vector<double> const& velocity) const;
};

/// A motion that can take no step, and stays.
std::unique_ptr<ReducedMotion> standing(ReducedScene const& scene);

}  // namespace actio::scene
