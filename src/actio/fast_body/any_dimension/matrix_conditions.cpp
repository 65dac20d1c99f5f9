#include "actio/fast_body/any_dimension/matrix_conditions.hpp"

namespace actio::bodies {

namespace detail {

int sign_of_determinant(Eigen::MatrixXd a) {
  auto view = actio::detail::as_gsl(a);
  std::vector<std::size_t> rows(static_cast<std::size_t>(a.rows()));
  gsl_permutation permutation{rows.size(), rows.data()};
  int sign = 1;
  gsl_linalg_LU_decomp(&view.matrix, &permutation, &sign);
  return gsl_linalg_LU_sgndet(&view.matrix, sign);
}

bool positive_definite(Eigen::MatrixXd a) {
  for (Eigen::Index k = 0; k < a.cols(); ++k) {
    if (!(a(k, k) > 0)) return false;
    Eigen::Index const left = a.rows() - k - 1;
    for (Eigen::Index j = 0; j < left; ++j)
      a.col(k + 1 + j).tail(left) -= a.col(k).tail(left) * (a(k + 1 + j, k) / a(k, k));
  }
  return true;
}

void require_rotation(Eigen::MatrixXd const& g, int n, char const* where) {
  constexpr double most = 1e-8;
  if (g.rows() != n || g.cols() != n)
    throw OutsideDomain(where, "as many rows and columns as there are Lambda are needed; rows",
                        static_cast<double>(g.rows()), n);
  require_finite(g, where);
  double distance = 0;
  for (int j = 0; j < n; ++j)
    for (int i = 0; i <= j; ++i) distance = std::max(distance, std::abs(g.col(i).dot(g.col(j)) - (i == j)));
  if (!(distance < most))
    throw OutsideDomain(where, "a rotation is needed; largest entry of g^T g - 1", distance, most);
  if (int const det = sign_of_determinant(g); det != 1)
    throw OutsideDomain(where, "a rotation is needed; its determinant", det, 1);
}

}  // namespace detail

}  // namespace actio::bodies
