// Arithmetic of quaternions, scalar first, shared by the methods that turn one.
#pragma once

#include <cmath>

#include "peers/stepper.hpp"

namespace peers {

/// (M, q) with q replaced by q (e0, e).
[[gnu::always_inline]] inline void turn_attitude(Seven& y, double e0, double e1, double e2, double e3) {
  double const a = y[3], b = y[4], c = y[5], d = y[6];
  y[3] = a * e0 - b * e1 - c * e2 - d * e3;
  y[4] = a * e1 + e0 * b + c * e3 - d * e2;
  y[5] = a * e2 + e0 * c + d * e1 - b * e3;
  y[6] = a * e3 + e0 * d + b * e2 - c * e1;
}
/// Back to unit length, by one step of Newton's method: there is never more to mend than rounding.
[[gnu::always_inline]] inline void mend_attitude(Seven& y) {
  double const factor = 1.5 - 0.5 * (y[3] * y[3] + y[4] * y[4] + y[5] * y[5] + y[6] * y[6]);
  for (int i = 3; i < 7; ++i) y[i] *= factor;
}

}  // namespace peers
