// Motions of a body in space under a torque: kicks, and the exact flow of the free body in between. Heavy
// tops and bodies under a torque of their own share them.
#pragma once

#include <Eigen/Core>

#include <variant>

#include "program/systems/bodies/formula_torque.hpp"
#include "program/systems/bodies/turning_body.hpp"

namespace actio::scene {

/// The torques that a scene may name: one of a potential, or formulas with or without such a one.
using AnyTorque = std::variant<bodies::GravityGradient, bodies::UniformGravity,
                               bodies::PotentialTorque<FormulaPotential>, FormulaTorque>;

/// A body under a torque, in steps.
class TorquedMotion : public TurningBody {
 public:
  /// Of the state that quantities are those of.
  virtual double time() const = 0;
};

/// The motion from a state at the time 0.
/// @param order  of the scheme, as the scene has it: "2", which is Strang's, or "4", that of Blanes and Moan;
///               under a torque without a potential Suzuki's composition
std::unique_ptr<TorquedMotion> torqued_motion(PrincipalInertia const& inertia, bodies::FreeState const& start,
                                              AnyTorque const& torque, double step, std::string const& order);

/// Between two kicks the torque is taken to be as at the first of them. So the scheme is meant for steps in
/// which the body turns little.
namespace turn_of_a_step {
constexpr double much = 0.25,  ///< radians; longer steps are remarked on
    most = 1;                  ///< radians; longer steps are refused
}  // namespace turn_of_a_step

/// Refuses a step in which the body may turn too far, with the longest that would do, and remarks on one in
/// which it may turn far.
/// @param fastest  bound of the angular velocity, 1/time
/// @param what     may turn: "the top may turn"
void check_turn_of_step(SceneTable const& method, Schedule const& schedule, double step, double fastest,
                        std::string const& what, std::vector<std::string>& remarks);

/// A bound of the frequencies of swings in a potential with the second derivative K: the root of the norm of
/// \f$I^{-1/2}KI^{-1/2}\f$; 1/time.
/// @param curvature  K, along turns in the body, energy
double swing_frequency(PrincipalInertia const& inertia, Eigen::Matrix3d const& curvature);
/// The same of a body that hangs in uniform gravity.
/// @param lever  weight times centre of mass, energy
double swing_of_weight(PrincipalInertia const& inertia, Eigen::Vector3d const& lever);

/// How much a step takes: how often the body moves freely between kicks.
double work_of_step(std::string const& order);

/// The record of the method.
Method variational_method(std::string const& torque);

}  // namespace actio::scene
