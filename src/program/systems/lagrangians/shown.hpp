// How the page of a run shows what is computed of a system with a Lagrangian of one's own.
#pragma once

#include "program/registry/quantity.hpp"
#include "program/systems/lagrangians/input.hpp"

namespace actio::scene {

/// Momenta as trajectories; of a group that moves the plane or the space rigidly the configuration as a frame
/// that moves, and the carried vectors with it.
void show_reduced(std::vector<Quantity>& quantities, ReducedScene const& scene);

}  // namespace actio::scene
