// Rotations by angles up to pi, in 50 digits, and how far their logarithm is off.
#pragma once

#include "actio/numbers/multiprecision.hpp"
#include "actio/groups/rotations.hpp"
#include "witness/draw.hpp"

namespace actio::testing {

inline double const eps = epsilon<double>();

/// pi - 10^-k; with k = 0 the angle is 1.
inline dec50 angle_before_pi(int k) {
  if (k == 0) return 1;
  dec50 gap = 1;
  for (int i = 0; i < k; ++i) gap /= 10;
  return acos(dec50(-1)) - gap;
}

/// A random vector of length 1.
template <int n>
Matrix<dec50, n, 1> direction(Draw& draw) {
  Matrix<dec50, n, 1> v = draw.vector<dec50, Matrix<dec50, n, 1>>(n);
  return v / dec50(sqrt(v.squaredNorm()));
}

/// A rotation vector that turns two planes by two angles, seen from a random frame.
template <int n>
Coordinates<SO<n>, dec50> in_a_random_frame(Draw& draw, dec50 const& first, dec50 const& second) {
  Coordinates<SO<n>, dec50> v = Coordinates<SO<n>, dec50>::Zero();
  v[0] = first, v[SO<n>::dim - 1] = second;
  auto const frame = exp(draw.velocity<dec50>(SO<n>{}, 2));
  return Ad(frame, velocity(SO<n>{}, v)).coordinates;
}

/// exp(v) computed in 50 digits and rounded to double, so that the only error of its logarithm is that of one
/// rounding and of `log` itself. The error of `log`, relative to v.
template <Group G>
double error_of_log(G const& group, Coordinates<G, dec50> const& v) {
  auto const g = exp(velocity(group, v));
  Element<G, double> rounded{group, g.value.template cast<double>()};
  Coordinates<G, dec50> const found = log(rounded).coordinates.template cast<dec50>();
  return to_double(magnitude((found - v).eval())) / to_double(magnitude(v));
}

}  // namespace actio::testing
