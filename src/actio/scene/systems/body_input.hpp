// What the scenes of bodies in space have in common: inertia, attitude, and the momentum at the start.
#pragma once

#include "actio/scene/system.hpp"
#include "actio/rigid_body/inertia.hpp"

namespace actio::scene {

/// The inertia of a body, in the frame in which the scene gives it, and in its own.
struct GivenInertia {
  Inertia<3> principal;                                 ///< along its principal axes
  Eigen::Matrix3d axes = Eigen::Matrix3d::Identity();  ///< principal axes as columns, in the frame as given; a rotation
  bool turned = false;                                  ///< whether the two frames differ

  /// In the frame as given.
  Eigen::Matrix3d tensor() const { return axes * principal.moments.asDiagonal() * axes.transpose(); }
  /// Of the body with this angular velocity, both in the frame as given; energy x time.
  Eigen::Vector3d momentum(Eigen::Vector3d const& velocity) const {
    return axes * Eigen::Vector3d(principal.moments).cwiseProduct(axes.transpose() * velocity);
  }
  /// Of the body with this momentum, both in the frame as given; 1/time.
  Eigen::Vector3d velocity(Eigen::Vector3d const& momentum) const {
    return axes * (axes.transpose() * momentum).cwiseQuotient(Eigen::Vector3d(principal.moments));
  }
};

/// `inertia`, principal or a tensor.
/// @throws SceneError  where no body has it
GivenInertia read_inertia(SceneTable const& system);
/// `body` or `inertia`.
GivenInertia read_body_or_inertia(SceneTable const& system);

/// `attitude`, body to space: a unit quaternion, scalar first, a rotation matrix, or a turn about an axis; the
/// identity, written back, where it is left out. Off by at most 1e-9 it is normalised, and said in `remarks`.
/// @throws SceneError  where it is farther off, with the normalised value
Eigen::Vector4d read_attitude(SceneTable initial, std::vector<std::string>& remarks);

/// `angular_velocity` or `angular_momentum`, as body momentum in the frame as given.
Eigen::Vector3d read_momentum(SceneTable const& initial, GivenInertia const& inertia);

/// The records of `attitude`, `angular_velocity` and `angular_momentum`.
/// @param momentum  what is said of the momentum
std::vector<Parameter> initial_parameters(std::string const& momentum);

/// The rotation matrix of a unit quaternion.
Eigen::Matrix3d rotation(Eigen::Vector4d const& q);
/// The unit quaternion of a rotation matrix, scalar part not negative.
Eigen::Vector4d quaternion(Eigen::Matrix3d const& rotation);
/// The product.
Eigen::Vector4d compose(Eigen::Vector4d const& p, Eigen::Vector4d const& q);

}  // namespace actio::scene
