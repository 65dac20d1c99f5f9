#include <Eigen/Core>

#include "actio/sphere_fields/symbols.hpp"

namespace actio::sphere {

Eigen::ArrayXd symbol_factors(int n, Symbol symbol) {
  Eigen::ArrayXd factors = Eigen::ArrayXd::Ones(n);
  if (symbol == Symbol::berezin)
    for (int l = 1; l < n; ++l)
      factors[l] = factors[l - 1] * std::sqrt((n - static_cast<double>(l)) / (n + static_cast<double>(l)));
  return factors;
}

}  // namespace actio::sphere
