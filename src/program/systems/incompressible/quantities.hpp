// What can be told of an incompressible medium of a scene.
#pragma once

#include "program/systems/incompressible/motion.hpp"
#include "program/systems/media/quantities.hpp"

namespace actio::scene {

/// The records of its quantities.
std::vector<Quantity> incompressible_quantities(bool fluid);

/// How they come from its motion.
/// \copydetails define_medium
template <int d>
void define_incompressible(QuantityGraph& graph, MediumView<d> const& view,
                           IncompressibleSteps<d> const& motion, std::vector<MaterialLoop<d>> const& loops);

}  // namespace actio::scene
