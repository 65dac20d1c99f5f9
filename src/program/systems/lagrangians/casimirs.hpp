// The Casimirs of a system with a Lagrangian of one's own, as quantities of its run.
#pragma once

#include "program/registry/system.hpp"
#include "program/systems/lagrangians/motion.hpp"

namespace actio::scene {

/// Defines `casimir` where it was asked for, and says what each is.
/// @throws SceneError  where the algebra has none of degree one or two
void define_casimirs(Simulation& simulation, Request const& request, ReducedScene const& scene,
                     ReducedMotion const& motion);

}  // namespace actio::scene
