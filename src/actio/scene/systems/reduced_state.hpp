// What is computed of a state of a system with a Lagrangian of one's own.
#pragma once

#include "actio/scene/system.hpp"
#include "actio/scene/systems/reduced_motion.hpp"

namespace actio::scene {

/// Defines velocity, momenta, energy, configuration and the carried vectors.
/// @param motion  whose state they are of
void define_state(QuantityGraph& graph, ReducedScene const& scene, ReducedMotion const& motion);

}  // namespace actio::scene
