#include "actio/fast_body/any_dimension/skew_spectrum.hpp"

namespace actio::bodies {
namespace detail {
namespace {

/// What stands beside the diagonal once reflections have made a skew matrix tridiagonal.
std::vector<double> skew_tridiagonal(Eigen::MatrixXd a) {
  Eigen::Index const n = a.rows();
  std::vector<double> beside;
  Eigen::VectorXd v(n), w(n);
  for (Eigen::Index k = 0; k + 1 < n; ++k) {
    Eigen::Index const left = n - k - 1;
    v.head(left) = a.col(k).tail(left);
    double const size = v.head(left).norm(), turned = v[0] < 0 ? size : -size;
    beside.push_back(size);
    v[0] -= turned;
    double const square = v.head(left).squaredNorm();
    if (!(square > 0)) continue;
    // (1 - 2 v v^T/|v|^2) A (1 - 2 v v^T/|v|^2) = A + v w^T - w v^T with w = 2 A v/|v|^2, since v^T A v = 0.
    w.head(left).setZero();
    for (Eigen::Index j = 0; j < left; ++j) w.head(left) += a.col(k + 1 + j).tail(left) * (2 / square * v[j]);
    for (Eigen::Index j = 0; j < left; ++j)
      a.col(k + 1 + j).tail(left) += v.head(left) * w[j] - w.head(left) * v[j];
  }
  return beside;
}

/// How many eigenvalues of the symmetric tridiagonal matrix with zeros on its diagonal are below x > 0.
int count_below(std::vector<double> const& beside_squared, double x) {
  double const least = std::numeric_limits<double>::min();
  int count = 1;
  double pivot = -x;
  for (double const b2 : beside_squared) {
    pivot = -x - b2 / pivot;
    // A pivot of zero is as good as one beside it.
    if (std::abs(pivot) < least) pivot = -least;
    count += pivot < 0;
  }
  return count;
}

}  // namespace
}  // namespace detail

Eigen::VectorXd skew_spectrum(Eigen::MatrixXd const& a) {
  Eigen::Index const n = a.rows();
  if (a.cols() != n || n == 0)
    throw OutsideDomain("skew spectrum", "a square matrix with at least one row is needed; columns",
                        static_cast<double>(a.cols()), static_cast<double>(n));
  require_finite(a, "skew spectrum");
  Eigen::VectorXd moduli = Eigen::VectorXd::Zero(n);
  // In a unit near the largest entry, so that squares are numbers.
  int exponent = 0;
  std::frexp(magnitude(a), &exponent);
  auto squares =
      detail::skew_tridiagonal(a * std::ldexp(1.0, -exponent / 2) * std::ldexp(1.0, exponent / 2 - exponent));
  double largest = 0;
  for (double& b : squares) largest = std::max(largest, b), b *= b;
  double const high = 2 * largest,
               nothing = 8 * static_cast<double>(n) * std::numeric_limits<double>::epsilon() * largest;
  for (Eigen::Index k = 0; k < n / 2 && largest > 0; ++k) {
    // The k-th from the top.
    double below = nothing, above = high;
    if (detail::count_below(squares, below) > n - 1 - k) break;
    for (double middle = (below + above) / 2; below < middle && middle < above; middle = (below + above) / 2)
      (detail::count_below(squares, middle) > n - 1 - k ? above : below) = middle;
    moduli[n - 1 - 2 * k] = moduli[n - 2 - 2 * k] = std::ldexp(below, exponent);
  }
  return moduli;
}

}  // namespace actio::bodies
