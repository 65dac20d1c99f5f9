// What can be told of two bodies that attract each other.
#pragma once

#include "program/systems/two_bodies/motion.hpp"

namespace actio::scene {

/// All of them, each after what it needs.
std::vector<Quantity> pair_quantities();
/// How they come from a motion.
void define_pair(QuantityGraph& graph, PairMotion const& motion);

/// Those that tell how a motion depends on its start.
std::vector<Quantity> tangent_quantities();
/// How these come from a motion that follows its tangent map.
void define_tangent(QuantityGraph& graph, PairMotion const& motion);

}  // namespace actio::scene
