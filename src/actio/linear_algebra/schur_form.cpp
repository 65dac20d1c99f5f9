#include "actio/linear_algebra/schur_form.hpp"

namespace actio {

SchurForm<double> schur_form(Matrix<double> const& a) {
  if (a.rows() != a.cols() || a.rows() == 0)
    throw OutsideDomain("schur_form", "a square matrix with at least one row is needed; its rows and columns",
                        static_cast<double>(a.rows()), static_cast<double>(a.cols()));
  require_finite(a, "schur_form");
  auto const n = static_cast<std::size_t>(a.rows());
  // GSL reads and writes row by row.
  Matrix<double> form = a.transpose(), vectors(a.rows(), a.cols());
  std::vector<double> values(2 * n);
  auto t = gsl_matrix_view_array(form.data(), n, n), u = gsl_matrix_view_array(vectors.data(), n, n);
  auto w = gsl_vector_complex_view_array(values.data(), n);
  std::unique_ptr<gsl_eigen_nonsymm_workspace, decltype(&gsl_eigen_nonsymm_free)> const work(
      gsl_eigen_nonsymm_alloc(n), &gsl_eigen_nonsymm_free);
  gsl_eigen_nonsymm_params(1, 0, work.get());
  gsl_error_handler_t* const previous = gsl_set_error_handler_off();
  int const status = gsl_eigen_nonsymm_Z(&t.matrix, &w.vector, &u.matrix, work.get());
  gsl_set_error_handler(previous);
  if (status != GSL_SUCCESS)
    throw NotConverged("schur_form: " + std::string(gsl_strerror(status)), {}, to_double(epsilon<double>()));
  SchurForm<double> found{vectors.transpose(), form.transpose()};
  for (Index i = 2; i < found.form.rows(); ++i)
    for (Index j = 0; j < i - 1; ++j) found.form(i, j) = 0;
  return found;
}

}  // namespace actio
