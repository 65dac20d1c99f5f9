// What is asked of a matrix: that it is a rotation, of the right size; that it is positive definite.
#pragma once

#include <Eigen/Core>

#include <gsl/gsl_linalg.h>

#include <vector>

#include "actio/linear_algebra/eigenvalues.hpp"

namespace actio::bodies::detail {

/// The sign of the determinant, 0 for a singular matrix; by the elimination of GSL.
int sign_of_determinant(Eigen::MatrixXd a);

/// Whether a symmetric matrix is positive definite, by the pivots of the elimination.
bool positive_definite(Eigen::MatrixXd a);

/// @throws NotFinite      where an entry is no number
/// @throws OutsideDomain  where g is not n by n, has an entry of \f$g^Tg - 1\f$ of 1e-8 or more, or is a
///                        reflection
void require_rotation(Eigen::MatrixXd const& g, int n, char const* where);

}  // namespace actio::bodies::detail
