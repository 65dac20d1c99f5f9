// What can be told of a rod of a scene.
#pragma once

#include "program/systems/rods/motion.hpp"

namespace actio::scene {

/// The records of its quantities.
std::vector<Quantity> rod_quantities();
/// How they come from its motion.
/// @param motion        outlives the graph
/// @param longest_step  that is stable
void define_rod(QuantityGraph& graph, RodMotion const& motion, double longest_step);

}  // namespace actio::scene
