// Galerkin's method for a Lagrangian of one's own: the generic implementation on a group that is known when
// the program runs.
#pragma once

#include <Eigen/Core>

#include "program/systems/lagrangians/motion.hpp"

namespace actio::scene {

/// Steps of order 2 s, s the number of stages of the scheme.
/// @throws Error  where the first step cannot be made
std::unique_ptr<ReducedMotion> galerkin_motion(ReducedScheme const& scheme, double step,
                                               systems::ReducedPoint const& start,
                                               std::vector<double> const& velocity,
                                               Eigen::MatrixXd const& configuration);

}  // namespace actio::scene
