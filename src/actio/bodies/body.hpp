// A body of the catalogue: what is known of it, in the frame in which it is given.
#pragma once

#include <Eigen/Core>

#include <string>
#include <vector>

#include "actio/rigid_body/inertia_of_parts.hpp"

namespace actio {

/// A body of the catalogue. Its frame is that of the moments, of the tensor or of the parts that the
/// catalogue gives.
struct Body {
  std::string name;     ///< its key in the catalogue
  std::string title;    ///< for people
  std::string source;   ///< where the figures are from
  std::string derived;  ///< what was computed from them, and how; may be empty
  std::string time;     ///< unit of time of `spin`
  /// of the moments: "kg m^2", or "ratio" where only their ratios are known
  std::string unit;
  /// inertia about the centre of mass: principal moments, and their axes in the frame of the body
  PrincipalInertia principal;
  /// body velocity at the start, in the frame of the body; rad per unit of time
  Velocity<SO<3>, double> spin;
  /// that the body is made of, from its centre of mass; empty where its inertia is given otherwise
  std::vector<PointMass> points;
  std::vector<Cylinder> cylinders;  ///< likewise

  /// `spin` along the principal axes, in which the inertia is diagonal.
  Velocity<SO<3>, double> principal_spin() const {
    return velocity(SO<3>{}, (principal.axes.transpose() * Eigen::Vector3d(spin.coordinates)).eval());
  }
};

}  // namespace actio
