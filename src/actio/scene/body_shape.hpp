// What a body in space looks like, as far as a scene says it: principal moments and axes, a fixed point and the parts of a body of the catalogue.
#pragma once

#include <optional>

#include "actio/scene/scene.hpp"

#include <Eigen/Core>

namespace actio::scene {

/// A body, in the frame in which the scene gives its inertia.
struct BodyShape {
  /// A solid cylinder about `along`, or a ball.
  struct Part {
    bool cylinder;
    double radius, length;
    Eigen::Vector3d at, along;  ///< from the centre of mass
  };
  Eigen::Vector3d moments;      ///< principal, about the centre of mass
  Eigen::Matrix3d axes;         ///< principal axes as columns
  std::vector<Part> parts;      ///< of a body of the catalogue that is made of such
  /// A body with a fixed point, in a uniform field.
  struct Top {
    double mass;
    Eigen::Vector3d centre_of_mass;  ///< from the fixed point
    Eigen::Vector3d gravity;         ///< in space
  };
  std::optional<Top> top;
};

/// The body that turns in a scene; none where none does.
std::optional<BodyShape> body_shape(Scene const& scene);

}  // namespace actio::scene
