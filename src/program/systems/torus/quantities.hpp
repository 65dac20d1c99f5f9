// What can be told of a flow on the torus.
#pragma once

#include "program/systems/torus/motion.hpp"

namespace actio::scene {

/// `energy`, `enstrophy`, `casimirs`, `eigenvalues`, `eigenvalue_drift`, `extrema`, `spectrum`: their
/// records.
std::vector<Quantity> torus_quantities();

/// How these come from a motion.
void define_torus(QuantityGraph& graph, TorusMotion const& motion,
                  std::shared_ptr<TorusFlow const> const& flow);

}  // namespace actio::scene
