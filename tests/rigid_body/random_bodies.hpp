// Bodies and motions at random, the same ones in every run.
#pragma once

#include <random>

#include "actio/rigid_body/inertia.hpp"

namespace actio::testing {

inline constexpr unsigned seed = 1971;

/// A body with Lambda between 0.5 and 2, and a velocity with components between -1 and 1.
template <int n>
struct RandomBody {
  Inertia<n> inertia;
  Velocity<SO<n>, double> spin;
};
template <int n>
RandomBody<n> random_body(std::mt19937& random, int size = n) {
  std::uniform_real_distribution<double> uniform(-1, 1);
  Matrix<double, n, 1> lambda(size);
  for (auto& l : lambda) l = 1.25 + 0.75 * uniform(random);
  auto const inertia = inertia_from_lambda<n, double>(lambda);
  Coordinates<SO<n>, double> xi(inertia.group.dimension());
  for (auto& x : xi) x = uniform(random);
  return {inertia, velocity(inertia.group, xi)};
}

/// Order of a method: slope of the least squares line through the logarithms, and the largest distance of a
/// point from it.
struct Fit {
  double slope, spread;
};
inline Fit fit_order(std::vector<double> const& steps, std::vector<double> const& errors) {
  double x = 0, y = 0, xx = 0, xy = 0, n = static_cast<double>(steps.size());
  for (std::size_t i = 0; i < steps.size(); ++i) {
    double const u = std::log(steps[i]), v = std::log(errors[i]);
    x += u, y += v, xx += u * u, xy += u * v;
  }
  double const slope = (n * xy - x * y) / (n * xx - x * x), start = (y - slope * x) / n;
  double spread = 0;
  for (std::size_t i = 0; i < steps.size(); ++i)
    spread = std::max(spread, std::abs(std::log(errors[i]) - start - slope * std::log(steps[i])));
  return {slope, spread};
}

}  // namespace actio::testing
