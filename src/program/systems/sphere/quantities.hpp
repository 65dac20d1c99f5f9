// What can be told of a flow on the sphere.
#pragma once

#include "program/systems/sphere/histogram.hpp"
#include "program/systems/sphere/steps.hpp"

namespace actio::scene {

/// `energy`, `enstrophy`, `angular_momentum`, `casimirs`, `eigenvalues`, `extrema`, `histogram`, `spectrum`,
/// `velocity_spectrum`, `enstrophy_spectrum`, `splitting`: their records.
std::vector<Quantity> vorticity_quantities();

/// How these come from a motion.
void define_vorticity(QuantityGraph& graph, VorticityMotion const& motion,
                      std::shared_ptr<SphereFlow const> flow);

/// The bins of the histogram: between the extremes at the start. O(N^3) operations.
HistogramBins histogram_bins(SphereFlow const& flow);

/// The largest norm of W, that of Frobenius, with which no Casimir leaves the numbers.
inline constexpr double largest_norm_for_casimirs = 1e37;

}  // namespace actio::scene
