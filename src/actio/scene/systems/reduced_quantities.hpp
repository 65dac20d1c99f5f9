// What can be told of a system with a Lagrangian of one's own.
#pragma once

#include "actio/scene/system.hpp"
#include "actio/scene/systems/reduced_motion.hpp"

namespace actio::scene {

/// The quantities that every such system has.
std::vector<Quantity> reduced_quantities();
/// Those that a scene names: the vectors that its motion carries.
std::vector<Quantity> named_quantities(SceneFile const& file);
/// All of a scene. What its symmetry keeps depends on the side, and on whether a vector breaks it.
std::vector<Quantity> quantities_of(SceneFile const& file, ReducedScene const& scene);

/// Defines velocity, momenta, energy, configuration and the carried vectors.
/// @param motion  whose state they are of
void define_state(QuantityGraph& graph, ReducedScene const& scene, ReducedMotion const& motion);
/// Defines `casimir` where it was asked for, and says what each is.
/// @throws SceneError  where the algebra has none of degree one or two
void define_casimirs(Simulation& simulation, Request const& request, ReducedScene const& scene,
                     ReducedMotion const& motion);

}  // namespace actio::scene
