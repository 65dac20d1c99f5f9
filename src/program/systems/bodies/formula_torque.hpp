// A torque on a body that comes from no potential: three formulas of a scene, beside one that does.
//
//     [system.torque]
//     body = ["-c*w1", "-c*w2", "jet - c*w3"]
//     parameters = { c = 0.1 }
//     inputs = { jet = "0.2*(t < 5)" }
#pragma once

#include <Eigen/Core>

#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "actio/fast_body/space/gravity_gradient.hpp"
#include "actio/fast_body/space/uniform_gravity.hpp"
#include "actio/fast_body/space/velocity_torque.hpp"
#include "program/document/key.hpp"
#include "program/systems/bodies/formula_potential.hpp"
#include "program/systems/held_inputs.hpp"

namespace actio::scene {

/// The torques of potentials that a scene may name.
using TorqueOfPotential =
    std::variant<bodies::GravityGradient, bodies::UniformGravity, bodies::PotentialTorque<FormulaPotential>>;

/// Its keys.
struct FormulaTorqueKeys : KeyTable {
  AnyKey body = key(
      "body", "a list of three formulas", LeftOut{"none"},
      "The torque along the axes of the body that comes from no potential: friction, a jet, a motor. "
      "Formulas in the angular velocity w1, w2, w3 in the frame of the body, the entries r11 to r33 of the "
      "rotation matrix, the time t, the parameters, the definitions and the inputs of this table. It is "
      "added to that of a potential.",
      "[\"-c*w1\", \"drag\", \"jet\"]");
  AnyKey parameters = key("parameters", "a table by names of one's own", LeftOut{"none"},
                          "Numbers by whose names the torque uses them; each is used.", "{ c = 0.1 }");
  AnyKey definitions =
      key("definitions", "a table of formulas by names of one's own", LeftOut{"none"},
          "Formulas by whose names the torque and each other use them.", "{ drag = \"-c*w2*abs(w2)\" }");
  AnyKey inputs = key("inputs", "a table by names of one's own", LeftOut{"none"},
                      "Numbers that the torque is given as functions of time, each held over a step at its "
                      "value in the middle, as system.inputs of a Lagrangian has them.",
                      "{ jet = \"0.2*(t < 5)\" }");
};
inline FormulaTorqueKeys const formula_torque_keys{{"system.torque"}};  ///< its keys

/// The torque. One thread at a time evaluates it; a copy is another one.
class FormulaTorque {
 public:
  /// @throws SceneError  where a formula is none, or nothing uses a name
  explicit FormulaTorque(SceneTable const& torque);
  /// The same with the torque of a potential added.
  FormulaTorque with(std::optional<TorqueOfPotential> beside) const;

  /// The torque on the body in its own axes, energy.
  /// @param q       unit quaternion, body to space
  /// @param w       angular velocity in the frame of the body, 1/time
  /// @param middle  of the step, at which the inputs are taken
  bodies::Three<double> operator()(bodies::Four<double> const& q, double time, bodies::Three<double> const& w,
                                   double middle) const;
  /// How its own part changes with the angular velocity, at a place and a time as above: energy x time.
  Eigen::Matrix3d slope(bodies::Four<double> const& q, double time, bodies::Three<double> const& w) const;
  /// How many operations a value takes.
  std::size_t operations() const { return components_.instructions.size(); }

 private:
  void set_inputs(bodies::Four<double> const& q, double time, bodies::Three<double> const& w,
                  double middle) const;

  Tape components_;
  std::vector<systems::HeldInput> held_;
  std::optional<TorqueOfPotential> beside_ = {};
  mutable std::vector<double> inputs_, work_;
};

}  // namespace actio::scene
