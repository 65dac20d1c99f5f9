// The eigenvalues of a skew matrix: they are i times real numbers, in pairs of opposite signs, and zero once
// more where the size is odd.
//
// Reflections take the matrix to tridiagonal form, which diag(1, i, i^2, ...) takes to i times a symmetric
// one with a diagonal of zeros. Its positive eigenvalues are found by bisection on the signs of its pivots,
// each for itself: nothing that has to converge.
#pragma once

#include <Eigen/Core>

#include <algorithm>
#include <limits>
#include <vector>

#include "actio/numbers/errors.hpp"

namespace actio::bodies {
namespace detail {}  // namespace detail

/// The moduli of the eigenvalues of a skew matrix, in ascending order: as many as it has rows, those of a
/// pair equal.
///
/// Moduli below 8 n epsilon of the largest, which rounding cannot tell from zero, are zero.
/// @param a  skew; only what is below the diagonal counts
/// @throws NotFinite, OutsideDomain  where an entry is no number, or the matrix is not square or empty
/// Accuracy: n epsilon of the largest or so.
Eigen::VectorXd skew_spectrum(Eigen::MatrixXd const& a);

}  // namespace actio::bodies
