// The implicit midpoint rule, with the attitude by Cayley's map: conserves energy, amount and spatial
// momentum.
//
//     M' - M = h m x w, m = (M + M')/2, w = m/I; M' is M turned by Cay(-h w), the attitude is turned by Cay(h
//     w).
#pragma once

#include "peers/quaternion.hpp"

namespace peers {

/// One step, the equation for m by Newton's method.
class ImplicitMidpoint {
 public:
  ImplicitMidpoint(Task const& task, double h) : half_(h / 2) {
    for (int i = 0; i < 3; ++i) J_[i] = 1 / task.I[i];
    for (int i = 0; i < 3; ++i) c_[i] = half_ * (J_[(i + 2) % 3] - J_[(i + 1) % 3]);
  }

  [[gnu::always_inline]] void operator()(Seven& y) const {
    // f = m - M - (c0 m1 m2, c1 m2 m0, c2 m0 m1) = 0, starting with the explicit step of half the length.
    double const M0 = y[0], M1 = y[1], M2 = y[2];
    double x = M0 + c_[0] * M1 * M2, v = M1 + c_[1] * M2 * M0, z = M2 + c_[2] * M0 * M1;
    for (int iteration = 0; iteration < 20; ++iteration) {
      double const f0 = x - M0 - c_[0] * v * z, f1 = v - M1 - c_[1] * z * x, f2 = z - M2 - c_[2] * x * v;
      // The matrix 1 - A has A01 = c0 z, A02 = c0 v, A10 = c1 z, A12 = c1 x, A20 = c2 v, A21 = c2 x.
      double const a01 = c_[0] * z, a02 = c_[0] * v, a10 = c_[1] * z, a12 = c_[1] * x, a20 = c_[2] * v,
                   a21 = c_[2] * x;
      double const k00 = 1 - a12 * a21, k01 = a01 + a02 * a21, k02 = a02 + a01 * a12;
      double const k10 = a10 + a12 * a20, k11 = 1 - a02 * a20, k12 = a12 + a02 * a10;
      double const k20 = a20 + a10 * a21, k21 = a21 + a01 * a20, k22 = 1 - a01 * a10;
      double const over = 1 / (k00 - a10 * k01 - a20 * k02);
      double const d0 = over * (k00 * f0 + k01 * f1 + k02 * f2), d1 = over * (k10 * f0 + k11 * f1 + k12 * f2),
                   d2 = over * (k20 * f0 + k21 * f1 + k22 * f2);
      x -= d0, v -= d1, z -= d2;
      // Quadratic convergence: after a change this small the next is below rounding.
      if (d0 * d0 + d1 * d1 + d2 * d2 <= 1e-18 * (x * x + v * v + z * z)) break;
    }
    y[0] = 2 * x - M0, y[1] = 2 * v - M1, y[2] = 2 * z - M2;
    double const a = half_ * J_[0] * x, b = half_ * J_[1] * v, c = half_ * J_[2] * z,
                 e = 1 / std::sqrt(1 + a * a + b * b + c * c);
    turn_attitude(y, e, e * a, e * b, e * c);
    mend_attitude(y);
  }

 private:
  double half_;
  std::array<double, 3> J_, c_;
};

inline Method implicit_midpoint() {
  return {"implicit midpoint",
          [](Task const& task, double h) { return stepper(task.start(), ImplicitMidpoint(task, h)); }};
}

}  // namespace peers
