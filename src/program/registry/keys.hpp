// The keys of a scene: the records that the reader takes its keys from, and that `actio list keys`, `actio
// show` and the book tell.
//
// [scene], [method], [run] and [output] have the same keys in every system; [system] and [initial] are told
// by each system.
#pragma once

#include <string>
#include <vector>

#include "program/registry/system.hpp"

namespace actio::scene {

/// Every key of a scene of this system, section by section in the order of a scene; words that are allowed
/// are those of this system.
std::vector<Parameter> keys_of(System const& system);

/// The keys of one table, without its name: `every` of "run", `degrees` of "initial.attitude".
std::vector<std::string> keys_in(std::vector<Parameter> const& keys, std::string const& table);

/// The tables that hold keys: "scene", "system", "initial", "initial.attitude", ...
std::vector<std::string> tables_of(std::vector<Parameter> const& keys);

/// A key, and the systems in which it is exactly this.
struct KeyOfSystems {
  Parameter parameter;            ///< the key
  std::vector<System const*> of;  ///< not empty
};

/// The keys of all systems, section by section; a key that is not the same in all systems is there several
/// times.
std::vector<KeyOfSystems> all_keys();

/// Refuses every key of the scene that its system does not have, and says which system has it.
/// @throws SceneError  at the first such key
void allow_keys(SceneFile const& file, System const& system);

/// Refuses a method or a quantity that other systems have and this one has not, with their names. One that no
/// system has is left to who reads it.
/// @throws SceneError  at the first such word
void refuse_words_of_other_systems(SceneFile const& file, System const& system);

}  // namespace actio::scene
