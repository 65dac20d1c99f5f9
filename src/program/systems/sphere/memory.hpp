// How much memory a flow on the sphere takes.
#pragma once

#include <string>
#include <vector>

#include "actio/vorticity/vorticity_step.hpp"

namespace actio::scene {

/// The memory that a run takes at most, in bytes: the program, and real matrices of the size N for each part
/// of the step and for the most demanding of the quantities.
/// @param to_rounding  whether steps are found in double precision throughout
/// @param substeps    of a step: 1, or those of a composition, each of which has its own steps to guess from
/// @param quantities  that were asked for
/// Accuracy: runs were measured to take as much or up to a third less, for N from 256 on.
double bytes_for_vorticity(int n, std::size_t substeps, sphere::Conserved conserved, bool to_rounding,
                           std::vector<std::string> const& quantities);
/// What all ranks together have of matrices that they multiply, bytes: eight real ones of the size N.
inline double bytes_dealt(int n) { return 64.0 * n * n; }

}  // namespace actio::scene
