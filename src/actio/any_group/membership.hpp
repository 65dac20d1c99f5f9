// Whether a matrix is an element of a group that is told at run time.
#pragma once

#include <Eigen/Core>

#include <limits>

#include "actio/any_group/span_of_matrices.hpp"
#include "actio/linear_algebra/determinant.hpp"

namespace actio::systems {

/// How far from the group a matrix may be that counts as an element.
inline constexpr double largest_distance_from_group = 1e-9;

namespace detail {}  // namespace detail

/// Whether a matrix can be an element of the connected group with this algebra.
///
/// It must take the algebra to itself, \f$g e_a g^{-1}\f$ being in the span, with a positive determinant. If
/// the group has a name, restoring g through the library must leave it where it is. If not, g must preserve
/// what the algebra says that all elements preserve: volumes where all traces vanish, the vectors and
/// covectors that the algebra takes to zero; and a matrix near the identity must have its logarithm in the
/// algebra. Farther away these conditions are necessary, and a matrix that meets them may belong to a larger
/// group.
///
/// @param distance  the largest of what was measured; infinite where g is not of the right size, not finite,
///                  or without an inverse. At most \ref largest_distance_from_group for an element
bool is_element(MatrixAlgebra const& algebra, Eigen::MatrixXd const& g, double& distance);

}  // namespace actio::systems
