// Bodies for the tests of the natural-chart scheme on SO(n), n at run time.
#pragma once

#include <Eigen/Core>

#include "../rigid_body/random_bodies.hpp"
#include "actio/fast_body/any_dimension/natural_chart_n.hpp"

namespace actio::testing {

inline constexpr int n_ = Eigen::Dynamic;

/// A body and the momentum it starts with.
struct Case {
  Inertia<n_> inertia;
  Momentum<SO<n_>, double> pi;
};
/// A random body whose velocity, as a matrix, has the norm 1.
inline Case random_case(std::mt19937& random, int n) {
  auto const [inertia, spin] = random_body<n_>(random, n);
  return {
      inertia,
      body_momentum(inertia, spin / bodies::skew_spectrum(inertia.group.hat(spin.coordinates)).maxCoeff())};
}
inline double difference(Eigen::MatrixXd const& a, Eigen::MatrixXd const& b) { return (a - b).norm(); }

}  // namespace actio::testing
