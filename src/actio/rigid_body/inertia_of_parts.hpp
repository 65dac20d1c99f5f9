// The inertia of a body that is made of parts: point masses and solid cylinders.
#pragma once

#include <Eigen/Core>

#include <vector>

#include "actio/rigid_body/principal_inertia.hpp"

namespace actio {

/// A point mass; kg, m.
struct PointMass {
  double mass;         ///< kg
  Eigen::Vector3d at;  ///< where it is, m
};
/// A solid cylinder of uniform density with its centre at `at`; kg, m.
struct Cylinder {
  double mass;            ///< kg
  double radius;          ///< m
  double length;          ///< m
  Eigen::Vector3d at;     ///< its centre, m
  Eigen::Vector3d along;  ///< direction of its axis, of any length
};

/// The tensor of inertia of point masses about the origin.
inline Eigen::Matrix3d inertia_tensor(PointMass const& p) {
  return p.mass * (p.at.squaredNorm() * Eigen::Matrix3d::Identity() - p.at * p.at.transpose());
}
/// The tensor of inertia of a cylinder about the origin: \f$\tfrac12mr^2\f$ about its axis,
/// \f$\tfrac1{12}m(3r^2+l^2)\f$ across, and its centre as a point mass.
Eigen::Matrix3d inertia_tensor(Cylinder const& c);
/// The same parts, seen from their common centre of mass.
template <class Part>
std::vector<Part> from_centre_of_mass(std::vector<Part> parts) {
  double mass = 0;
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();
  for (auto const& part : parts) mass += part.mass, centre += part.mass * part.at;
  centre /= mass;
  for (auto& part : parts) part.at -= centre;
  return parts;
}
/// The tensor of inertia of several parts about the origin.
template <class Part>
Eigen::Matrix3d inertia_tensor(std::vector<Part> const& parts) {
  Eigen::Matrix3d sum = Eigen::Matrix3d::Zero();
  for (auto const& part : parts) sum += inertia_tensor(part);
  return (sum + sum.transpose()) / 2;
}
/// The tensor of inertia of several parts about their common centre of mass.
template <class Part>
Eigen::Matrix3d inertia_about_centre(std::vector<Part> const& parts) {
  return inertia_tensor(from_centre_of_mass(parts));
}

}  // namespace actio
