// What is computed of a state of a system with a Lagrangian of one's own.
#pragma once

#include "program/registry/system.hpp"
#include "program/systems/lagrangians/motion.hpp"

namespace actio::scene {

/// Defines velocity, momenta, energy, configuration and the carried vectors.
/// @param motion  whose state they are of
void define_state(QuantityGraph& graph, ReducedScene const& scene, ReducedMotion const& motion);

}  // namespace actio::scene
