// The Casimirs of a system with a Lagrangian of one's own, as quantities of its run.
#pragma once

#include "actio/scene/system.hpp"
#include "actio/scene/systems/reduced_motion.hpp"

namespace actio::scene {

/// Defines `casimir` where it was asked for, and says what each is.
/// @throws SceneError  where the algebra has none of degree one or two
void define_casimirs(Simulation& simulation, Request const& request, ReducedScene const& scene,
                     ReducedMotion const& motion);

}  // namespace actio::scene
