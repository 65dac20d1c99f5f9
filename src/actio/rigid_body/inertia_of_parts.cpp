#include "actio/rigid_body/inertia_of_parts.hpp"

namespace actio {

Eigen::Matrix3d inertia_tensor(Cylinder const& c) {
  Eigen::Vector3d const axis = c.along.stableNormalized();
  double const about = c.mass * c.radius * c.radius / 2,
               across = c.mass * (3 * c.radius * c.radius + c.length * c.length) / 12;
  return across * Eigen::Matrix3d::Identity() + (about - across) * axis * axis.transpose() +
         inertia_tensor(PointMass{c.mass, c.at});
}

}  // namespace actio
