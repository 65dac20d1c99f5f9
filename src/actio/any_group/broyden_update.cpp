#include "actio/any_group/broyden_update.hpp"

namespace actio::systems {

bool broyden_update(std::vector<double>& inverse, std::vector<double> const& step,
                    std::vector<double> const& weights, std::vector<double>& update) {
  auto const d = step.size();
  double square = 0, together = 0;
  for (std::size_t i = 0; i < d; ++i) {
    double const weighted = step[i] * weights[i];
    square += weighted * step[i], together += weighted * update[i];
  }
  double const rest = square - together;
  if (!(rest > square / 2)) return false;
  for (std::size_t j = 0; j < d; ++j) {
    double along = 0;
    for (std::size_t i = 0; i < d; ++i) along += step[i] * weights[i] * inverse[i * d + j];
    along /= rest;
    for (std::size_t i = 0; i < d; ++i) inverse[i * d + j] += update[i] * along;
  }
  for (double& u : update) u *= square / rest;
  return true;
}

}  // namespace actio::systems
