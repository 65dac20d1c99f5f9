// Numbers that forces and torques of a scene are given as functions of time: a table `inputs`.
#pragma once

#include <string>
#include <vector>

#include "actio/any_group/generalized_force.hpp"
#include "program/systems/shared_names.hpp"

namespace actio::scene {

/// The inputs of a table, each held over a step at its value in the middle.
struct HeldInputs {
  std::vector<std::string> names = {};          ///< in the order of the scene
  std::vector<systems::HeldInput> values = {};  ///< one for each name

  /// Refuses one that does not occur.
  /// @param used      the names that do
  /// @param formulas  what they are called together
  void require_used(SceneTable const& inputs, SharedNames::Names const& used,
                    std::string const& formulas) const;
};

/// Reads them: a formula of t, rows of a time and the value from then on, or a file of such rows.
/// @param taken   names of other numbers of the force
/// @param shared  parameters and definitions, which the formulas may use
/// @throws SceneError  where one is none of these, or has a name that it cannot have
HeldInputs read_held_inputs(SceneTable const& inputs, std::vector<std::string> const& taken,
                            SharedNames& shared);

}  // namespace actio::scene
