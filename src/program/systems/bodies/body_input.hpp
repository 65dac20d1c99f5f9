// What the scenes of bodies in space have in common: inertia, attitude, and the momentum at the start. All of
// them are in the frame in which the scene gives the inertia.
#pragma once

#include <Eigen/Core>

#include "actio/fast_body/space/free_body.hpp"
#include "program/registry/system.hpp"

namespace actio::scene {

/// `inertia`, principal or a tensor.
/// @throws SceneError  where no body has it
PrincipalInertia read_inertia(SceneTable const& system);
/// `body` or `inertia`.
PrincipalInertia read_body_or_inertia(SceneTable const& system);

/// `attitude`, body to space: a unit quaternion, scalar first, a rotation matrix, or a turn about an axis;
/// the identity, written back, where it is left out. Off by at most 1e-9 it is normalised, and said in
/// `remarks`.
/// @throws SceneError  where it is farther off, with the normalised value
Eigen::Vector4d read_attitude(SceneTable initial, std::vector<std::string>& remarks);

/// `angular_velocity` or `angular_momentum`, as body momentum.
Momentum<SO<3>, double> read_momentum(SceneTable const& initial, PrincipalInertia const& inertia);
/// Attitude and momentum at the start.
bodies::FreeState read_start(SceneTable const& initial, PrincipalInertia const& inertia,
                             std::vector<std::string>& remarks);

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
