// Motions with constraints on the velocity.
#pragma once

#include "program/systems/lagrangians/motion.hpp"

namespace actio::scene {

/// A motion in steps of the discrete principle of Lagrange and d'Alembert, whose point obeys the constraints.
std::unique_ptr<ReducedMotion> constrained_motion(ReducedScheme const& scheme, double step,
                                                  systems::ReducedPoint const& start,
                                                  std::vector<double> const& velocity,
                                                  Eigen::MatrixXd const& configuration);

/// Defines `reaction` and `constraint`.
/// @param motion  whose state they are of
void define_constraints(QuantityGraph& graph, ReducedScene const& scene, ReducedMotion const& motion);

}  // namespace actio::scene
