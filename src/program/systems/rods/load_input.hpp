// What acts on a rod of a scene: [system.boundary] and [system.load].
#pragma once

#include "actio/rods/rod_ends.hpp"
#include "actio/rods/rod_shape.hpp"
#include "program/document/key.hpp"
#include "program/systems/shared_names.hpp"

namespace actio::scene {

/// Supports and loads of a rod.
struct SceneRodLoads {
  rods::RodLoads loads;  ///< as the library has them
  bool held = false,     ///< whether an end is held
      moved = false,     ///< whether one is moved
      loaded = false;    ///< whether a force or a moment acts on one
};

/// Reads them.
/// @param start   the shape at the time 0, which supports must meet
/// @param length  of the rod
/// @throws SceneError  where a value is wrong, where a moved end is elsewhere at the start, and where a load
///                     acts on what is held
SceneRodLoads read_rod_loads(SceneFile const& file, rods::RodShape const& start, double length,
                             SharedNames& shared);
/// The records of its keys.
std::vector<Parameter> rod_load_parameters();

}  // namespace actio::scene
