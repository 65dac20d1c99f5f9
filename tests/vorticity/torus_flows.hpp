// Flows on the torus for the tests.
#pragma once

#include <Eigen/Core>

#include <random>

#include "actio/quantized_torus/torus_invariants.hpp"

namespace actio::testing {

/// Random coefficients of the wave numbers up to `most` in either direction, the same for a seed.
inline torus::TorusHarmonics random_torus_harmonics(int n, int most, unsigned seed = 1) {
  std::mt19937 random(seed);
  std::normal_distribution<double> normal;
  torus::TorusHarmonics f(n);
  for (int k = 0; k <= most; ++k)
    for (int m = k == 0 ? 1 : -most; m <= most; ++m) {
      double const real = normal(random), imaginary = normal(random);
      f.set(m, k, std::complex<double>(real, imaginary) / (1 + std::hypot(m, k)));
    }
  return f;
}
inline sphere::SkewHermitian<> random_torus_state(int n, int most, unsigned seed = 1) {
  return torus::matrix_of(random_torus_harmonics(n, most, seed));
}

}  // namespace actio::testing
