// What a scene says of a force on a Lagrangian of one's own: `force` and `inputs` of [system].
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "program/systems/held_inputs.hpp"
#include "program/systems/lagrangians/input.hpp"

namespace actio::scene {

/// Its keys.
struct ForceKeys : KeyTable {
  AnyKey force = key(
      "force", "a list of formulas, or a table of some by the names of the components", LeftOut{"none"},
      "The force, a formula for each component of the velocity, of which it is the covector: its power is "
      "the sum of their products. Formulas have the components of the velocity, those of the momentum as "
      "p_w1, those of the carried vectors, the time t, the parameters and the inputs; a component without "
      "a formula is 0. momentum_level takes no forces.",
      "{ v1 = \"-0.1*v1*abs(v1)\" }");
  AnyKey force_in_space =
      key("force_in_space", "a list of formulas, or a table of some by the names of the components",
          LeftOut{"none"},
          "A force that is added, in components of the velocity in space, g' g^-1: formulas of the same "
          "names as those of `force`. Where it is constant, the momentum in space grows in proportion to the "
          "time. On SE(3) it is a torque about the origin of space and a force along a line through it. For "
          "left-invariant Lagrangians, with natural_chart or cayley_chart.",
          "{ v2 = \"0.3\" }");
  AnyKey inputs =
      key("inputs", "a table by names of one's own", LeftOut{"none"},
          "Numbers that the force is given as functions of time, each held over a step at its value in the "
          "middle: a formula of t, \"20*(t < 5)\", rows of a time and the value from then on, [[0, 20], [5, "
          "0]], or a file of such rows, \"thrust.csv\". Where one jumps, a step should end.",
          "{ thrust = \"20*(t < 5)\" }");
};
inline ForceKeys const force_keys{{"system"}};  ///< its keys

/// Names that a force has and no other formula: those of the momentum, and the time.
std::vector<std::string> names_of_force(systems::MatrixAlgebra const& algebra);

/// The force, with the part in components of space; none where the scene has neither.
/// @param carried  the names of the components of the carried vectors
/// @param shared   the names that formulas share; those that the force uses are marked
/// @throws SceneError  where a formula is none, a component or an input has a name that it cannot have, or
///                     nothing uses an input
std::optional<systems::GeneralizedForce> read_force(SceneFile const& file,
                                                    systems::MatrixAlgebra const& algebra,
                                                    std::vector<std::string> const& carried,
                                                    SharedNames& shared);

/// Refuses a force that is no number at the start, by its own components.
void require_force(SceneTable const& system, ReducedScene const& scene);
/// Refuses a force in components of space on the right, and under constraints.
void require_force_in_space(SceneTable const& system, systems::Side side);

}  // namespace actio::scene
