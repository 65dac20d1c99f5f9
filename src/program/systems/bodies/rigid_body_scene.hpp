// What a scene says of a rigid body in space, free or under a torque, and the motion that it asks for.
#pragma once

#include "program/systems/bodies/torque_input.hpp"
#include "program/systems/method_input.hpp"

namespace actio::scene {

/// A scene of a rigid body.
struct RigidBodyScene {
  /// What steps it.
  enum class Scheme {
    moser_veselov,  ///< its equation, with the moments of inertia or modified ones
    natural_chart,  ///< the kinetic energy through the natural chart
    variational     ///< the exact flow, between kicks of a torque
  };
  SceneTable system,                  ///< its section
      initial,                        ///< its section
      method;                         ///< its section
  std::vector<std::string> remarks;   ///< what was done to the input
  PrincipalInertia inertia;           ///< of the body
  std::optional<SceneTorque> torque;  ///< none: the body is free
  bodies::FreeState start;            ///< momentum and attitude
  bodies::FreeBody free;              ///< the body without its torque
  MethodChoice choice;                ///< of the method and its order
  Scheme scheme;                      ///< that of the method
  double fastest,  ///< a bound of the angular velocity, or of what else the step is measured by, 1/time
      step;        ///< time

  /// Reads it.
  /// @param methods  of the system
  /// @throws SceneError  where a value is missing or wrong
  RigidBodyScene(Request const& request, std::vector<Method> const& methods);

  /// Whether a free body has the exact flow in steps.
  bool has_exact_flow() const { return scheme == Scheme::variational && !torque; }
  /// Of a step, as `Simulation` has it.
  double work() const;
  /// Whether it goes to any time at once.
  bool is_exact() const { return choice.order == "exact"; }
};

/// The motion of a scene.
struct RigidBodyMotion {
  std::unique_ptr<TurningBody> motion;     ///< that quantities look at
  TorquedMotion const* torqued = nullptr;  ///< the same, where the body is under a torque
  std::string failure;                     ///< why it cannot take a step; it is the start alone then
};

/// Sets it up, and remarks on a long step.
RigidBodyMotion motion_of(RigidBodyScene& scene, Schedule const& schedule);

/// From which the error is estimated: for a free body the true motion, which takes as long as some fifty
/// steps, so that rows some 128 steps apart are compared; under a torque motions with steps three and six
/// times as long.
/// @param wanted    as `Request` has it
/// @param attitude  whether the attitude is reconstructed
Companion companion_of(RigidBodyScene const& scene, std::optional<bool> wanted, bool attitude);

}  // namespace actio::scene
