// The differential equations of the free body, for the methods that solve differential equations: M' = M x w,
// q' = q (0, w)/2, w = M/I.
#pragma once

#include "peers/stepper.hpp"

namespace peers {

/// The right side, with as few operations as it takes.
struct EulerEquations {
  double a, b, c;  ///< \f$1/I_k-1/I_j\f$
  double p, q, r;  ///< \f$1/(2I_i)\f$

  explicit EulerEquations(Task const& task)
      : a(1 / task.I[2] - 1 / task.I[1]),
        b(1 / task.I[0] - 1 / task.I[2]),
        c(1 / task.I[1] - 1 / task.I[0]),
        p(0.5 / task.I[0]),
        q(0.5 / task.I[1]),
        r(0.5 / task.I[2]) {}

  template <class In, class Out>
  [[gnu::always_inline]] void rate(In const& y, Out& f) const {
    double const x = y[0], v = y[1], z = y[2], e = y[3], i = y[4], j = y[5], k = y[6];
    double const wx = p * x, wy = q * v, wz = r * z;
    f[0] = a * v * z;
    f[1] = b * z * x;
    f[2] = c * x * v;
    f[3] = -(i * wx + j * wy + k * wz);
    f[4] = e * wx + j * wz - k * wy;
    f[5] = e * wy + k * wx - i * wz;
    f[6] = e * wz + i * wy - j * wx;
  }
};

}  // namespace peers
