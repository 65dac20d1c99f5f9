// What the scenes of bodies in space have in common: inertia, attitude, and the momentum at the start. All of
// them are in the frame in which the scene gives the inertia.
#pragma once

#include <Eigen/Core>

#include "actio/fast_body/space/free_body.hpp"
#include "program/catalogue/bodies.hpp"
#include "program/registry/system.hpp"

namespace actio::scene {

/// A free body, of the library or by its inertia.
struct BodyKeys : KeyTable {
  Key<std::string> body =
      key("body", one_of("body", names_of_bodies(), "actio list bodies"), LeftOut{"or system.inertia"},
          "A body of the library, with its inertia (actio list bodies).", "\"apophis\"");
  AnyKey inertia = key("inertia", "three numbers, or a symmetric 3 by 3 matrix", LeftOut{"or system.body"},
                       "The moments of inertia about the centre of mass, along the axes of the body "
                       "frame, or the tensor in that frame.",
                       "[1, 2, 3]", "mass x length^2");
};
/// Its keys.
BodyKeys const& body_keys();

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

/// `angular_momentum` of [initial], with what is said of it.
struct MomentumKeys : KeyTable {
  std::string meaning;  ///< of its record
  Key<Eigen::Vector3d> angular_momentum =
      key("angular_momentum", vector.in("energy x time"), LeftOut{"or initial.angular_velocity"}, meaning,
          "[0.1, 4, 0.3]");
};
/// The records of [initial].
std::vector<Parameter> initial_parameters(MomentumKeys const& momentum);

/// The rotation matrix of a unit quaternion.
Eigen::Matrix3d rotation(Eigen::Vector4d const& q);
/// The unit quaternion of a rotation matrix, scalar part not negative.
Eigen::Vector4d quaternion(Eigen::Matrix3d const& rotation);
/// The product.
Eigen::Vector4d compose(Eigen::Vector4d const& p, Eigen::Vector4d const& q);

}  // namespace actio::scene
