// How far what the motion conserves walks away in many steps. Measured in long double from the states, which
// are double.
#pragma once

#include <cmath>

#include "peers/stepper.hpp"

namespace benchmark {

/// Relative change of what is conserved.
struct Drift {
  double amount;   ///< of |M|
  double energy;   ///< of the energy
  double spatial;  ///< of the momentum in space, as a vector, over its magnitude
};

/// Amount, energy, and momentum in space with the quaternion taken at unit length.
struct Conserved {
  long double amount, energy;
  std::array<long double, 3> spatial;

  Conserved(peers::Task const& task, peers::Seven const& y) {
    using Wide = long double;
    Wide const x = y[0], v = y[1], z = y[2], e = y[3], a = y[4], b = y[5], c = y[6],
               n = e * e + a * a + b * b + c * c;
    amount = std::sqrt(x * x + v * v + z * z);
    energy = (x * x / task.I[0] + v * v / task.I[1] + z * z / task.I[2]) / 2;
    // M + 2 q x (q x M + e M), over |q|^2.
    Wide const p = b * z - c * v + e * x, q = c * x - a * z + e * v, r = a * v - b * x + e * z;
    spatial = {x + 2 * (b * r - c * q) / n, v + 2 * (c * p - a * r) / n, z + 2 * (a * q - b * p) / n};
  }
};

inline Drift drift_of(peers::Task const& task, peers::Stepper& stepper, long steps) {
  Conserved const before(task, stepper.state());
  stepper.advance(steps);
  Conserved const after(task, stepper.state());
  long double square = 0;
  for (int i = 0; i < 3; ++i)
    square += (after.spatial[i] - before.spatial[i]) * (after.spatial[i] - before.spatial[i]);
  return {static_cast<double>(after.amount / before.amount - 1),
          static_cast<double>(after.energy / before.energy - 1),
          static_cast<double>(std::sqrt(square) / before.amount)};
}

}  // namespace benchmark
