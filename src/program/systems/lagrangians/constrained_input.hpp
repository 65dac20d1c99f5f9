// What a scene says of constraints on the velocity: `system.constraints` and `initial.project`.
#pragma once

#include <string>
#include <vector>

#include "program/systems/lagrangians/input.hpp"
#include "program/systems/shared_names.hpp"

namespace actio::scene {

KeyTable const& constraint_keys();         ///< in [system]
KeyTable const& constrained_start_keys();  ///< in [initial]

/// The formulas that vanish, in the velocity, the vectors and the time `t`; none where the scene has none.
/// @param names   of the components of velocity and vectors
/// @param shared  the names that formulas share; those that occur are marked
/// @throws SceneError  where one is no formula, at its place
std::vector<Tape> read_constraints(SceneTable const& system, std::vector<std::string> names,
                                   SharedNames& shared);

/// Constrains a scene, and moves its start on the constraints.
/// @throws SceneError  where a constraint is not linear in the velocity, where they depend on each other or
///                     leave no motion, and where the velocity at the start breaks them
void constrain(SceneFile const& file, std::vector<Tape> const& each, ReducedScene& scene,
               std::vector<std::string>& remarks);

/// Whether some constraint does not hold at rest: a table that turns, a belt that runs.
bool constraints_move(ReducedScene const& scene);

}  // namespace actio::scene
