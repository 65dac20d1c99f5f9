// What the two systems of incompressible media have in common (thesis, chapters 7, 8 and 10): their keys, and
// a motion made from a scene.
#pragma once

#include "program/registry/system.hpp"

namespace actio::scene {

/// How incompressible media are stepped.
std::vector<Method> incompressible_methods();

/// A system of incompressible media, by its name, title, meaning and example: a fluid, or a body.
System incompressible_system(bool fluid, std::string name, std::string title, std::string meaning,
                             std::string example);

}  // namespace actio::scene
