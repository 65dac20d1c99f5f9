// What a scene can ask of the method itself: defects of its steps, the order that it shows, tangent maps.
#pragma once

#include "program/systems/lagrangians/motion.hpp"

namespace actio::scene {

/// Defines `poisson_defect`, `symplectic_defect`, `leaf_defect`, `order` and `tangent_map`. Those but the
/// last are of the next step from the state of a row; each costs some tens of steps.
/// @param motion  whose state they are of
void define_instruments(QuantityGraph& graph, ReducedScheme const& scheme, double step,
                        ReducedMotion const& motion);

/// A motion that also follows how momentum and vectors change with those at the start.
/// @param step  of the motion, time
std::unique_ptr<ReducedMotion> following_tangent(std::unique_ptr<ReducedMotion> motion,
                                                 ReducedScheme const& scheme, double step);

}  // namespace actio::scene
