// What is computed of a state of a system with a Lagrangian of one's own.
#pragma once

#include "program/registry/system.hpp"
#include "program/systems/lagrangians/motion.hpp"

namespace actio::scene {

/// Defines velocity, momenta, energy, configuration and the carried vectors.
/// @param motion  whose state they are of
void define_state(QuantityGraph& graph, ReducedScene const& scene, ReducedMotion const& motion);

/// The directions of the basis whose motions leave every carried vector as it is: along these the symmetry
/// conserves the momentum, and momentum_balance has its components.
std::vector<std::size_t> conserved_directions(ReducedScene const& scene);

}  // namespace actio::scene
