#include "actio/multisymplectic/largest_frequency.hpp"

namespace actio::media {

namespace detail {

std::pair<double, double> top_of_lanczos_matrix(std::vector<double> const& a, std::vector<double> const& b) {
  std::size_t const n = a.size();
  double low = -HUGE_VAL, up = -HUGE_VAL;
  for (std::size_t k = 0; k < n; ++k) {
    double const around = (k > 0 ? b[k - 1] : 0) + (k + 1 < n ? b[k] : 0);
    low = std::max(low, a[k]), up = std::max(up, a[k] + around);
  }
  // All pivots of T - s are negative where s is above every eigenvalue.
  auto const above_all = [&](double s) {
    double pivot = a[0] - s;
    for (std::size_t k = 1; k < n && pivot < 0; ++k) pivot = a[k] - s - b[k - 1] * b[k - 1] / pivot;
    return pivot < 0;
  };
  for (int halving = 0; halving < 60; ++halving) {
    double const middle = 0.5 * (low + up);
    (above_all(middle) ? up : low) = middle;
  }
  double here = 1, next = 0, square = 1;
  for (std::size_t k = n; k-- > 1;) {
    double const before = ((up - a[k]) * here - (k + 1 < n ? b[k] : 0) * next) / b[k - 1];
    next = here, here = before, square += here * here;
  }
  return {up, 1 / std::sqrt(square)};
}

}  // namespace detail

}  // namespace actio::media
