// What a step changes energy and angular momentum by, and the numbers by which its displacement is moved
// along the orbit against it: a Newton step in each round of the fixed point.
//
// A changes by multiples of X_0 = C = [A, Wt] and X_j = [iS_j, Wt], which are the commutators of eps(P - Q)
// and iS_j with Wt: the changes of the invariants are <eps(P - Q), C> and <iS_j, C>, their derivatives in the
// factors minus the inner products of the X.
//
// Where a sphere turns fast, the X of the turns about the horizontal axes are longer than the others by its
// rotation over the flow. Beside them the others, by which energy and angular momentum along the axis are
// held, would fall below the cut-off, so that each X is taken in its own length. Near an equilibrium C is
// small, and what is divided by it should be more than rounding.
#pragma once

#include <Eigen/Core>

#include <cmath>
#include <limits>
#include <optional>
#include <vector>

#include "actio/quantized_sphere/spin_commutator.hpp"
#include "actio/quantized_sphere/turning_frame.hpp"
#include "actio/skew_matrices/dense_matrices.hpp"

namespace actio::sphere {

/// A round of a step.
struct StepRound {
  double eps;                                      ///< h/(2 hbar)
  SkewHermitian<> const& p;                        ///< P - Q; beside a background, of the flow alone
  SkewHermitian<> const& a;                        ///< A; beside a background, A'
  SkewHermitian<> const& middle;                   ///< Wt, or Vt
  SkewHermitian<> const& commutator;               ///< C
  std::vector<Eigen::Vector3d> const& directions;  ///< unit vectors e, along which L stays
  std::vector<SkewHermitian<>> const& turned;      ///< [ie.S, Wt] of each
};

namespace detail {}  // namespace detail

/// Adds a Newton step to the factors, that of X_0 first.
/// @param turn  a of the background, where there is one
/// @return      what energy and angular momentum change by in the step, as a change of W
double correct_factors(QuantizedSphere const& sphere, StepRound const& round, std::optional<double> turn,
                       Eigen::Vector4d& factors);

}  // namespace actio::sphere
