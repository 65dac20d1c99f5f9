// Rotations by angles up to pi, in 50 digits, and how far their logarithm is off. The arithmetic in force is
// Arithmetic::decimal(50).
#pragma once

#include "actio/groups/rotations.hpp"
#include "witness/draw.hpp"
#include "witness/number.hpp"

namespace actio::testing {

inline double const eps = epsilon<double>();

/// pi - 10^-k; with k = 0 the angle is 1.
inline Number angle_before_pi(int k) {
  if (k == 0) return 1;
  Number gap = 1;
  for (int i = 0; i < k; ++i) gap /= 10;
  return acos(Number(-1)) - gap;
}

/// A random vector of length 1.
template <int n>
Matrix<Number, n, 1> direction(Draw& draw) {
  Matrix<Number, n, 1> v = draw.vector<Number, Matrix<Number, n, 1>>(n);
  return v / Number(sqrt(v.squaredNorm()));
}

/// A rotation vector that turns two planes by two angles, seen from a random frame.
template <int n>
Coordinates<SO<n>, Number> in_a_random_frame(Draw& draw, Number const& first, Number const& second) {
  Coordinates<SO<n>, Number> v = Coordinates<SO<n>, Number>::Zero();
  v[0] = first, v[SO<n>::dim - 1] = second;
  auto const frame = exp(draw.velocity<Number>(SO<n>{}, 2));
  return Ad(frame, velocity(SO<n>{}, v)).coordinates;
}

/// The entries of a matrix, rounded.
template <class M>
auto in_double(M const& m) { return m.unaryExpr([](Number const& x) { return to_double(x); }); }

/// exp(v) computed in 50 digits and rounded to double, so that the only error of its logarithm is that of one
/// rounding and of `log` itself. The error of `log`, relative to v.
template <Group G>
double error_of_log(G const& group, Coordinates<G, Number> const& v) {
  auto const g = exp(velocity(group, v));
  Element<G, double> rounded{group, in_double(g.value)};
  Coordinates<G, Number> const found = log(rounded).coordinates.template cast<Number>();
  return to_double(magnitude((found - v).eval())) / to_double(magnitude(v));
}

}  // namespace actio::testing
