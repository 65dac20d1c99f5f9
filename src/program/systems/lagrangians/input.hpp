// What a scene says of a Lagrangian of one's own on a group: [system] and [initial] of `euler_poincare`.
#pragma once

#include <Eigen/Core>

#include <memory>
#include <string>
#include <vector>

#include "actio/any_group/chart_solver.hpp"
#include "actio/nonholonomic/velocity_constraints.hpp"
#include "program/document/key.hpp"

namespace actio::scene {

/// A vector that the motion carries.
struct CarriedVector {
  std::string name;          ///< as the scene writes it
  Eigen::VectorXd constant;  ///< fixed in space (left-invariant) or in the body (right-invariant)
  std::vector<std::string> components = {};  ///< their names; empty: that of the vector with a number
  std::size_t shown = 0;                     ///< how many of them a quantity has; 0: all
};

/// A system and its start, as a scene gives them.
struct ReducedScene {
  std::shared_ptr<systems::ReducedSystem const> system;  ///< of the scene
  std::vector<CarriedVector> carried;                    ///< in the order of the scene
  Eigen::MatrixXd configuration;                         ///< at the start
  std::vector<double> velocity;                          ///< at the start, 1/time
  systems::ReducedPoint start;                           ///< momentum and vectors at the start
  /// of the velocity; null where there are none
  std::shared_ptr<systems::VelocityConstraints const> constraints;
  std::vector<Tape> contact;  ///< where the body touches, in its frame, by the vectors; or none
};

/// The records of [system] and [initial].
std::vector<Parameter> reduced_parameters();

/// Reads [system] and [initial]; defaults are written back.
/// @throws SceneError  where a value is missing or wrong, with its place: an unknown group, a basis that is
///                     not independent or not closed, a formula that is none, a vector of the wrong length, a
///                     configuration that is no element, a Lagrangian that is not regular at the start
ReducedScene read_reduced_scene(SceneFile const& file, std::vector<std::string>& remarks);

/// The names of the vectors that [system.advected] lists.
std::vector<std::string> carried_names(SceneFile const& file);

}  // namespace actio::scene
