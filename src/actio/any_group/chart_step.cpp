#include "actio/any_group/chart_step.hpp"

namespace actio::systems {

namespace detail {

std::array<double, 65> const& coefficients_of_chi() {
  static auto const all = [] {
    std::array<double, 65> beta{1, 1.0 / 12, -1.0 / 720, 1.0 / 30240, -1.0 / 1209600, 1.0 / 47900160};
    for (int k = 6; k < 65; ++k) {
      double zeta = 0;
      for (int n = 12; n >= 1; --n) zeta += std::pow(n, -2 * k);
      beta[static_cast<std::size_t>(k)] = (k % 2 ? 2 : -2) * zeta * std::pow(2 * std::numbers::pi, -2 * k);
    }
    return beta;
  }();
  return all;
}

}  // namespace detail

}  // namespace actio::systems
