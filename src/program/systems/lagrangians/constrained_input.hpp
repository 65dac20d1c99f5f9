// What a scene says of constraints on the velocity: `system.constraints`, `system.contact`,
// `initial.project` and `method.conserve`.
#pragma once

#include <string>
#include <vector>

#include "program/systems/lagrangians/input.hpp"
#include "program/systems/shared_names.hpp"

namespace actio::scene {

KeyTable const& constraint_keys();          ///< in [system]
KeyTable const& constrained_start_keys();   ///< in [initial]
KeyTable const& constrained_method_keys();  ///< in [method]

/// The formulas that vanish, in the velocity, the vectors and the time `t`; none where the scene has none.
/// @param names   of the components of velocity and vectors
/// @param shared  the names that formulas share; those that occur are marked
/// @throws SceneError  where one is no formula, at its place
std::vector<Tape> read_constraints(SceneTable const& system, std::vector<std::string> names,
                                   SharedNames& shared);

/// Where the body touches, in its own frame, as formulas of the vectors; none where the scene does not say
/// it.
/// @param vectors  names of their components
/// @param shared   parameters and definitions
/// @throws SceneError  where there are no constraints, the group is not one of rigid motions, or a formula is
///                     missing or none
std::vector<Tape> read_contact(SceneTable const& system, systems::MatrixAlgebra const& algebra,
                               std::vector<std::string> const& vectors, SharedNames& shared);

/// Constrains a scene, and moves its start on the constraints.
/// @throws SceneError  where a constraint is not linear in the velocity, where they depend on each other or
///                     leave no motion, and where the velocity at the start breaks them
void constrain(SceneFile const& file, std::vector<Tape> const& each, ReducedScene& scene,
               std::vector<std::string>& remarks);

/// Whether steps conserve the energy: `method.conserve`.
/// @param name  of the method
/// @throws SceneError  where they cannot, with the reason
bool conserves_energy(SceneTable const& method, std::string const& name, ReducedScene const& scene);

/// Whether some constraint does not hold at rest: a table that turns, a belt that runs.
bool constraints_move(ReducedScene const& scene);

}  // namespace actio::scene
