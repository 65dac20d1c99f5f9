// What can be told of a body that turns in space: the quantities that free bodies and tops share.
#pragma once

#include <Eigen/Core>

#include "program/systems/bodies/body_input.hpp"

namespace actio::scene {

/// A motion of a body in space, seen in the frame in which the scene gives its inertia.
class TurningBody : public Motion {
 public:
  /// In the frame of the body; energy x time.
  virtual Eigen::Vector3d body_momentum() const = 0;
  /// Unit quaternion, body to space, its sign continuous in time.
  virtual Eigen::Vector4d attitude() const = 0;

  StateDistance distance(Motion const& other) const override;

  /// From now on the momentum alone is asked for: the attitude need not be reconstructed.
  void leave_attitude_out() { attitude_wanted_ = false; }

 protected:
  /// Whether the attitude is asked for as well.
  bool attitude_wanted() const { return attitude_wanted_; }

 private:
  bool attitude_wanted_ = true;
};

/// `attitude`, `angular_velocity`, `body_momentum`, `spatial_momentum`, in the order of the contract.
/// @param free  whether the momentum in space is conserved
std::vector<Quantity> turning_body_quantities(bool free);
/// How these come from a motion.
/// @param inertia  in the frame of the scene, as all else
void define_turning_body(QuantityGraph& graph, TurningBody const& motion, PrincipalInertia const& inertia);

/// A bound of the angular velocity of a body with that kinetic energy: \f$|\omega|^2 \le 2E/I_{min}\f$;
/// 1/time.
double fastest_turn(PrincipalInertia const& inertia, double kinetic_energy);

/// What the drift of a part of the angular momentum is compared with: its modulus, and where that is
/// rounding, as of a body at rest under a torque, what the body has where it turns at its own pace.
/// @param pace  a bound of angular velocities and frequencies, 1/time; of a free body at rest zero
QuantityGraph::Unit unit_of_momentum(double modulus, PrincipalInertia const& inertia, double pace);

}  // namespace actio::scene
