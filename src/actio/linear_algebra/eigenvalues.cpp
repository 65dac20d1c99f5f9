#include "actio/linear_algebra/eigenvalues.hpp"

namespace actio {

SymmetricEigen symmetric_eigen(Eigen::MatrixXd a) {
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

double largest_eigenvalue(Eigen::MatrixXd a) {
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

Eigen::VectorXd real_parts_of_eigenvalues(Eigen::MatrixXd a) {
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
