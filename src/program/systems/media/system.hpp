// What the two systems of media have in common (thesis, chapters 6 to 10): the multisymplectic scheme, its
// keys, and a motion made from a scene.
#pragma once

#include "program/registry/system.hpp"

namespace actio::scene {

/// A system of media, by its name, title, meaning and example: a fluid, or an elastic body. Its motion is
/// made by fused steps where the box of a scene allows them, else on a mesh.
System medium_system(bool fluid, std::string name, std::string title, std::string meaning,
                     std::string example);

}  // namespace actio::scene
