// The error of a run: its table against that of the truth.
#pragma once

#include "body_n.hpp"
#include "body_scene.hpp"

namespace command {

/// The columns of a vector, or of a matrix.
inline std::vector<std::vector<double>> columns(Table const& table, std::string const& name) {
  std::vector<std::vector<double>> out;
  for (auto const& column : table.columns)
    if (column.rfind(name + "_", 0) == 0) out.push_back(table[column]);
  return out;
}
/// The largest error until a time of attitude, configuration or momentum, as a run tells it.
/// @param n  of the matrices
inline double error_of(std::string const& name, int n, Table const& found, Table const& truth, double until) {
  auto const t = truth["t"];
  std::string const columns_of =
      name == "momentum" && truth.columns.back().rfind("body_", 0) == 0 ? "body_momentum" : name;
  auto const a = columns(found, columns_of), b = columns(truth, columns_of);
  BOOST_REQUIRE(!a.empty());
  double most = 0, modulus = 0;
  for (std::size_t row = 0; row < t.size() && t[row] <= until * (1 + 1e-12); ++row) {
    if (name == "momentum") {
      double apart = 0, size = 0;
      for (std::size_t k = 0; k < a.size(); ++k)
        apart += std::pow(a[k][row] - b[k][row], 2), size += std::pow(b[k][row], 2);
      most = std::max(most, std::sqrt(apart)), modulus = std::max(modulus, std::sqrt(size));
    } else if (name == "attitude" && a.size() == 4) {  // a quaternion, of either sign
      double less = 0, more = 0;
      for (std::size_t k = 0; k < 4; ++k)
        less += std::pow(a[k][row] - b[k][row], 2), more += std::pow(a[k][row] + b[k][row], 2);
      most = std::max(most, 4 * std::asin(std::min(1.0, std::sqrt(std::min(less, more)) / 2)));
    } else if (name == "attitude") {
      double apart = 0;
      for (std::size_t k = 0; k < a.size(); ++k) apart += std::pow(a[k][row] - b[k][row], 2);
      most = std::max(most, std::sqrt(apart / 2));
    } else {
      Square const g = matrix(found, name, n, row), h = matrix(truth, name, n, row);
      most = std::max(most, difference(g, h) / norm(h) * std::sqrt(n / 2.0));
    }
  }
  return name == "momentum" ? most / modulus : most;
}

}  // namespace command
