// A flow on the sphere at random.
#pragma once

#include <random>

#include "actio/quantized_sphere/matrix_harmonics.hpp"

// Its vorticity: of the degrees `first` to `last` the parts of every harmonic are drawn from the normal
// distribution of variance 1; the others are zero.
inline actio::sphere::SphereHarmonics random_flow(int degrees, int first, int last, unsigned seed) {
  std::mt19937 random(seed);
  std::normal_distribution<double> normal;
  actio::sphere::SphereHarmonics f(degrees);
  for (int l = first; l <= last; ++l)
    for (int m = 0; m <= l; ++m) {
      double const imaginary = m == 0 ? 0 : normal(random);  // drawn first
      f(l, m) = {normal(random), imaginary};
    }
  return f;
}
