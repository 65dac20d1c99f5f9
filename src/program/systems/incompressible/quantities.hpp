// What can be told of an incompressible medium of a scene.
#pragma once

#include "program/systems/incompressible/motion.hpp"
#include "program/systems/media/quantities.hpp"

namespace actio::scene {

/// The records of its quantities.
std::vector<Quantity> incompressible_quantities(bool fluid);
/// Those of the fluid on the sphere.
std::vector<Quantity> quantities_on_sphere();

/// How they come from its motion.
/// \copydetails define_medium
/// @tparam Medium  as of \ref IncompressibleSteps
template <class Medium>
void define_incompressible(QuantityGraph& graph, MediumView<Medium::N> const& view,
                           IncompressibleSteps<Medium> const& motion,
                           std::vector<MaterialLoop<Medium::N>> const& loops);

}  // namespace actio::scene
