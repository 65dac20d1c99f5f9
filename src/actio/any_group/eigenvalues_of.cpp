#include <Eigen/Core>

#include "actio/any_group/eigenvalues_of.hpp"

namespace actio::systems {

Eigen::VectorXcd eigenvalues_of(Eigen::MatrixXd a) {
  actio::detail::require_square(a, "eigenvalues_of");
  require_finite(a, "eigenvalues_of");
  Eigen::VectorXcd values(a.rows());
  auto m = actio::detail::as_gsl(a);
  auto w = gsl_vector_complex_view_array(reinterpret_cast<double*>(values.data()),
                                         static_cast<std::size_t>(a.rows()));
  std::unique_ptr<gsl_eigen_nonsymm_workspace, decltype(&gsl_eigen_nonsymm_free)> const work(
      gsl_eigen_nonsymm_alloc(static_cast<std::size_t>(a.rows())), &gsl_eigen_nonsymm_free);
  gsl_eigen_nonsymm_params(0, 1, work.get());
  gsl_error_handler_t* const previous = gsl_set_error_handler_off();
  int const status = gsl_eigen_nonsymm(&m.matrix, &w.vector, work.get());
  gsl_set_error_handler(previous);
  if (status != GSL_SUCCESS)
    throw NotConverged("eigenvalues_of: " + std::string(gsl_strerror(status)), {}, 0);
  return values;
}

}  // namespace actio::systems
