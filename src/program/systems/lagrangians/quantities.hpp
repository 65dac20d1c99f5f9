// What can be told of a system with a Lagrangian of one's own.
#pragma once

#include "program/registry/system.hpp"
#include "program/systems/lagrangians/motion.hpp"

namespace actio::scene {

/// The quantities that every such system has.
std::vector<Quantity> reduced_quantities();
/// Those that a scene names: the vectors that its motion carries.
std::vector<Quantity> named_quantities(SceneFile const& file);
/// All of a scene. What its symmetry conserves depends on the side, and on whether a vector breaks it.
std::vector<Quantity> quantities_of(SceneFile const& file, ReducedScene const& scene);

}  // namespace actio::scene
