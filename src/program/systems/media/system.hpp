// What the two systems of media have in common (thesis, chapters 6 to 10): the multisymplectic scheme, its
// keys, and a motion made from a scene.
#pragma once

#include "program/registry/system.hpp"

namespace actio::scene {

/// All keys of [system], [loads] and [method] of a fluid, or of an elastic body.
std::vector<Parameter> medium_scene_parameters(bool fluid);
/// The motion that a scene asks for: by fused steps where its box allows them, else on a mesh.
/// @throws SceneError  where a key is refused: at its place, with the value and the bound
Simulation prepare_medium(bool fluid, Request const& request);

}  // namespace actio::scene
