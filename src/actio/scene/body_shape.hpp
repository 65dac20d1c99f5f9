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
    bool cylinder;       ///< else a ball
    double radius,       ///< of either
        length;          ///< of the cylinder
    Eigen::Vector3d at,  ///< its centre, from the centre of mass
        along;           ///< the axis of the cylinder, a unit vector
  };
  Eigen::Vector3d moments;      ///< principal, about the centre of mass
  Eigen::Matrix3d axes;         ///< principal axes as columns
  std::vector<Part> parts;      ///< of a body of the catalogue that is made of such
  /// A body with a fixed point, in a uniform field.
  struct Top {
    double mass;                     ///< of the body
    Eigen::Vector3d centre_of_mass;  ///< from the fixed point
    Eigen::Vector3d gravity;         ///< in space
  };
  std::optional<Top> top;       ///< of a body with a fixed point
};

/// The body that turns in a scene; none where none does.
std::optional<BodyShape> body_shape(Scene const& scene);

}  // namespace actio::scene
