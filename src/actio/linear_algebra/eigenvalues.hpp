// Eigenvalues of real matrices in double, from the GNU Scientific Library: a call, where a template would
// cost every user seconds of compiling.
#pragma once

#include <Eigen/Core>

#include <gsl/gsl_eigen.h>
#include <gsl/gsl_errno.h>

#include <memory>

#include "actio/numbers/errors.hpp"

namespace actio {
namespace detail {

/// The entries of a column-major matrix as GSL sees them, row by row: its transpose, which has the same
/// eigenvalues.
inline gsl_matrix_view as_gsl(Eigen::MatrixXd& a) {
  return gsl_matrix_view_array(a.data(), static_cast<std::size_t>(a.cols()),
                               static_cast<std::size_t>(a.rows()));
}
inline gsl_vector_view as_gsl(Eigen::VectorXd& v) {
  return gsl_vector_view_array(v.data(), static_cast<std::size_t>(v.size()));
}

inline void require_square(Eigen::MatrixXd const& a, char const* where) {
  if (a.rows() != a.cols() || a.rows() == 0)
    throw OutsideDomain(where, "a square matrix with at least one row is needed; its rows and columns",
                        static_cast<double>(a.rows()), static_cast<double>(a.cols()));
}

}  // namespace detail

/// Eigenvalues and eigenvectors of a symmetric matrix.
struct SymmetricEigen {
  Eigen::VectorXd values;   ///< in ascending order
  Eigen::MatrixXd vectors;  ///< as columns, orthonormal
};

/// Diagonalizes a symmetric matrix.
///
/// @param a  symmetric; what is below the diagonal is not read
/// @throws NotFinite      where an entry is no number
/// @throws OutsideDomain  where it is not square, or empty
/// Accuracy: values to a few epsilon of the largest.
SymmetricEigen symmetric_eigen(Eigen::MatrixXd a);

/// The largest eigenvalue of a symmetric matrix.
/// @throws NotFinite  where an entry is no number
double largest_eigenvalue(Eigen::MatrixXd a);

/// The real parts of the eigenvalues of a matrix, in ascending order.
/// @throws NotFinite     where an entry is no number
/// @throws NotConverged  where the QR iteration does not end
Eigen::VectorXd real_parts_of_eigenvalues(Eigen::MatrixXd a);

}  // namespace actio
