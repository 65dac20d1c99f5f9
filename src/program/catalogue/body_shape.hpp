// What a body in space looks like, as far as a scene says it: principal moments and axes, a fixed point and
// the parts of a body of the catalogue.
#pragma once

#include <Eigen/Core>

#include <optional>
#include <vector>

#include "actio/bodies/body.hpp"

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
  /// A body with a fixed point, in a uniform field.
  struct Top {
    double mass;                     ///< of the body
    Eigen::Vector3d centre_of_mass;  ///< from the fixed point
    Eigen::Vector3d gravity;         ///< in space
  };
  PrincipalInertia inertia;      ///< about the centre of mass
  std::vector<Part> parts = {};  ///< of a body of the catalogue that is made of such
  std::optional<Top> top = {};   ///< of a body with a fixed point
  bool torqued = false;          ///< whether a torque changes the modulus of its momentum
};

/// One of two bodies that move about each other.
struct OrbitingBody {
  double mass;               ///< of the body
  double radius;             ///< no part of it is farther from its centre of mass
  PrincipalInertia inertia;  ///< about its centre of mass, in the frame in which its attitude is
};

/// What a body of the catalogue is made of: cylinders as they are, point masses as balls.
std::vector<BodyShape::Part> parts_of(Body const& body);

}  // namespace actio::scene
