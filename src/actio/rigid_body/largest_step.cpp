#include "actio/rigid_body/largest_step.hpp"

namespace actio {

namespace detail {

double spin_against_inertia(Vector<double> const& lambda, Matrix<double> const& m, double t) {
  double const s = std::exp(t);
  Index const n = lambda.size();
  // [longest_step]
  Vector<double> w(n);
  for (Index i = 0; i < n; ++i) w[i] = 1 / std::sqrt(lambda[i] * lambda[i] + s * s);
  Matrix<double> a(n, n), square(n, n);
  for (Index j = 0; j < n; ++j)
    for (Index i = 0; i < n; ++i) a(i, j) = w[i] * m(i, j) * w[j];
  // The spectral radius of i A, A skew, is the largest singular value of A.
  for (Index j = 0; j < n; ++j)
    for (Index i = 0; i < n; ++i) {
      square(i, j) = 0;
      for (Index k = 0; k < n; ++k) square(i, j) += a(k, i) * a(k, j);
    }
  return s * std::sqrt(largest_eigenvalue(square));
  // [longest_step]
}

}  // namespace detail

}  // namespace actio
