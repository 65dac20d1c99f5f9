// The torque on a body in space, [system.torque]: of a gradient of gravity, of uniform gravity on a body that
// is held at a point, or of a potential that is a formula; and one of formulas, without a potential.
#pragma once

#include <Eigen/Core>

#include <optional>

#include "program/systems/bodies/torqued_motion.hpp"

namespace actio::scene {

/// What a scene says of a torque, and what it leaves unchanged.
class SceneTorque {
 public:
  /// @throws SceneError  where it is none
  SceneTorque(SceneTable const& torque, PrincipalInertia const& inertia);

  /// For the motion.
  AnyTorque torque() const;
  /// Whether all of it comes from a potential.
  bool has_potential() const { return !formulas_; }
  /// V, energy; 0 where there is none.
  /// @param attitude  of the frame of the scene
  double potential(Eigen::Vector4d const& attitude, double time) const;
  /// Whether V depends on time, so that the energy is not conserved.
  bool depends_on_time() const { return rate_ != 0 || formula_in_time_; }
  /// Whether energy minus rate times momentum about the axis is conserved: V depends on time, if it does, as
  /// by a turn about the axis at that rate.
  bool is_steady() const { return !formula_in_time_; }
  /// The axis of space that goes with the torque, a unit vector.
  Eigen::Vector3d const& axis() const { return axis_; }
  /// Whether turns about the axis do not change V, so that the momentum about it is conserved.
  bool is_symmetric() const { return symmetric_; }
  /// At which V is turned about the axis, 1/time; 0 where it stands still.
  double rate() const { return rate_; }
  /// What steps are measured by, 1/time: a bound of the angular velocity, by the energy, and of the
  /// frequencies at which the body and the torque may swing. Of a formula it is estimated, from its values
  /// and derivatives at two thousand attitudes and times, fewer where the formula is long, and at some
  /// attitudes from bounds over all times, so that no short event is stepped over. Of formulas without a
  /// potential it is the pace at which they change the velocity, at that of the start and two hundred times.
  /// @param until    the last time
  /// @param remarks  are told what was not found out
  double pace(bodies::FreeState const& start, double until, std::vector<std::string>& remarks) const;
  /// How many steps take a few milliseconds, as `Simulation` has it.
  long steps_at_once() const;

 private:
  void read_gradient(SceneTable const& gradient);
  void read_uniform(SceneTable const& uniform);
  void read_formula(SceneTable const& torque);
  void check_start(FormulaPotential const& potential, bodies::FreeState const& start) const;
  double pace_of_formulas(bodies::FreeState const& start, double until) const;
  double pace_of(bodies::GravityGradient const& gradient, bodies::FreeState const& start) const;
  double pace_of(bodies::UniformGravity const& gravity, bodies::FreeState const& start) const;
  double pace_of(bodies::PotentialTorque<FormulaPotential> const& potential, bodies::FreeState const& start,
                 double until, std::vector<std::string>& remarks) const;

  SceneTable table_;
  PrincipalInertia inertia_;
  Place place_;  // of the formula
  std::optional<TorqueOfPotential> of_potential_;
  std::optional<FormulaTorque> formulas_;
  Eigen::Vector3d axis_ = Eigen::Vector3d::UnitZ();
  double rate_ = 0;
  bool formula_in_time_ = false, symmetric_ = false;
};

/// The torque of a scene; none where it has no [system.torque].
/// @param inertia  of the body
/// @throws SceneError  where it is wrong
std::optional<SceneTorque> read_torque(SceneTable const& system, PrincipalInertia const& inertia);

/// The records of [system.torque].
std::vector<Parameter> torque_parameters();

}  // namespace actio::scene
