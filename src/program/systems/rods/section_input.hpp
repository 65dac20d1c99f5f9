// The cross-section of a rod of a scene: [system.rod] section.
#pragma once

#include "actio/rods/rod_section.hpp"
#include "program/document/key.hpp"

namespace actio::scene {

/// Reads it; defaults are written back.
/// @param unshearable  whether stretch and shear are ruled out, so that nothing resists them
/// @throws SceneError  where a number is missing or wrong
rods::RodSection read_rod_section(SceneTable const& rod, bool unshearable);

}  // namespace actio::scene
