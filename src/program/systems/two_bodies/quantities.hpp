// What can be told of two bodies that attract each other.
#pragma once

#include "program/systems/two_bodies/motion.hpp"

namespace actio::scene {

/// All of them, each after what it needs.
std::vector<Quantity> pair_quantities();
/// How they come from a motion.
void define_pair(QuantityGraph& graph, PairMotion const& motion);

}  // namespace actio::scene
