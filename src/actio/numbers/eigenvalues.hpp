// Eigenvalues of real matrices in double, from the GNU Scientific Library: a call, where a template would
// cost every user seconds of compiling.
#pragma once

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
inline SymmetricEigen symmetric_eigen(Eigen::MatrixXd a) {
  detail::require_square(a, "symmetric_eigen");
  require_finite(a, "symmetric_eigen");
  Eigen::MatrixXd vectors(a.rows(), a.cols());
  SymmetricEigen found{Eigen::VectorXd(a.rows()), {}};
  auto m = detail::as_gsl(a), v = detail::as_gsl(vectors);
  auto w = detail::as_gsl(found.values);
  std::unique_ptr<gsl_eigen_symmv_workspace, decltype(&gsl_eigen_symmv_free)> const work(
      gsl_eigen_symmv_alloc(static_cast<std::size_t>(a.rows())), &gsl_eigen_symmv_free);
  gsl_eigen_symmv(&m.matrix, &w.vector, &v.matrix, work.get());
  gsl_eigen_symmv_sort(&w.vector, &v.matrix, GSL_EIGEN_SORT_VAL_ASC);
  found.vectors = vectors.transpose();
  return found;
}

/// The largest eigenvalue of a symmetric matrix.
/// @throws NotFinite  where an entry is no number
inline double largest_eigenvalue(Eigen::MatrixXd a) {
  detail::require_square(a, "largest_eigenvalue");
  require_finite(a, "largest_eigenvalue");
  Eigen::VectorXd values(a.rows());
  auto m = detail::as_gsl(a);
  auto w = detail::as_gsl(values);
  std::unique_ptr<gsl_eigen_symm_workspace, decltype(&gsl_eigen_symm_free)> const work(
      gsl_eigen_symm_alloc(static_cast<std::size_t>(a.rows())), &gsl_eigen_symm_free);
  gsl_eigen_symm(&m.matrix, &w.vector, work.get());
  return values.maxCoeff();
}

/// The real parts of the eigenvalues of a matrix, in ascending order.
/// @throws NotFinite     where an entry is no number
/// @throws NotConverged  where the QR iteration does not end
inline Eigen::VectorXd real_parts_of_eigenvalues(Eigen::MatrixXd a) {
  detail::require_square(a, "real_parts_of_eigenvalues");
  require_finite(a, "real_parts_of_eigenvalues");
  // GSL squares entries: bring the largest near 1, by a power of two, which rounds nothing.
  int exponent = 0;
  std::frexp(magnitude(a), &exponent);
  a *= std::ldexp(1.0, -exponent / 2), a *= std::ldexp(1.0, exponent / 2 - exponent);
  auto const n = static_cast<std::size_t>(a.rows());
  Eigen::VectorXcd values(a.rows());
  auto m = detail::as_gsl(a);
  auto w = gsl_vector_complex_view_array(reinterpret_cast<double*>(values.data()), n);
  std::unique_ptr<gsl_eigen_nonsymm_workspace, decltype(&gsl_eigen_nonsymm_free)> const work(
      gsl_eigen_nonsymm_alloc(n), &gsl_eigen_nonsymm_free);
  gsl_eigen_nonsymm_params(0, 1, work.get());  // balanced: rows and columns may differ in size
  gsl_error_handler_t* const previous = gsl_set_error_handler_off();
  int const status = gsl_eigen_nonsymm(&m.matrix, &w.vector, work.get());
  gsl_set_error_handler(previous);
  if (status != GSL_SUCCESS)
    throw NotConverged("real_parts_of_eigenvalues: " + std::string(gsl_strerror(status)), {},
                       to_double(epsilon<double>()));
  Eigen::VectorXd real = values.real();
  std::sort(real.begin(), real.end());
  for (double& x : real) x = std::ldexp(x, exponent);
  return real;
}

}  // namespace actio
