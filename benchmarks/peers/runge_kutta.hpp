// The classical method of Runge and Kutta, written for this body: every number a variable of its own, which
// the compiler may keep in a register. With the seven numbers in arrays the same formulas take up to twice as
// long.
#pragma once

#include "peers/euler_equations.hpp"

namespace peers {

/// The seven numbers one by one: momentum and quaternion.
struct Apart {
  double x, y, z, e, i, j, k;
};

/// One step of the method of order four.
class RungeKutta {
 public:
  RungeKutta(Task const& task, double h)
      : a_(EulerEquations(task).a),
        b_(EulerEquations(task).b),
        c_(EulerEquations(task).c),
        p_(0.5 / task.I[0]),
        q_(0.5 / task.I[1]),
        r_(0.5 / task.I[2]),
        h_(h) {}

  [[gnu::always_inline]] void operator()(Apart& s) const {
    double const h = h_, half = h / 2, sixth = h / 6;
    Apart const a = rate(s.x, s.y, s.z, s.e, s.i, s.j, s.k);
    Apart const b = rate(s.x + half * a.x, s.y + half * a.y, s.z + half * a.z, s.e + half * a.e,
                         s.i + half * a.i, s.j + half * a.j, s.k + half * a.k);
    Apart const c = rate(s.x + half * b.x, s.y + half * b.y, s.z + half * b.z, s.e + half * b.e,
                         s.i + half * b.i, s.j + half * b.j, s.k + half * b.k);
    Apart const d = rate(s.x + h * c.x, s.y + h * c.y, s.z + h * c.z, s.e + h * c.e, s.i + h * c.i,
                         s.j + h * c.j, s.k + h * c.k);
    s = {s.x + sixth * (a.x + 2 * (b.x + c.x) + d.x), s.y + sixth * (a.y + 2 * (b.y + c.y) + d.y),
         s.z + sixth * (a.z + 2 * (b.z + c.z) + d.z), s.e + sixth * (a.e + 2 * (b.e + c.e) + d.e),
         s.i + sixth * (a.i + 2 * (b.i + c.i) + d.i), s.j + sixth * (a.j + 2 * (b.j + c.j) + d.j),
         s.k + sixth * (a.k + 2 * (b.k + c.k) + d.k)};
  }

 private:
  [[gnu::always_inline]] Apart rate(double x, double y, double z, double e, double i, double j,
                                    double k) const {
    double const u = p_ * x, v = q_ * y, w = r_ * z;
    return {a_ * y * z,
            b_ * z * x,
            c_ * x * y,
            -(i * u + j * v + k * w),
            e * u + j * w - k * v,
            e * v + k * u - i * w,
            e * w + i * v - j * u};
  }

  double a_, b_, c_, p_, q_, r_, h_;
};

inline Method runge_kutta() {
  return {"Runge-Kutta, order 4", [](Task const& task, double h) {
            return stepper(Apart{task.M[0], task.M[1], task.M[2], 1, 0, 0, 0}, RungeKutta(task, h),
                           [](Apart const& s) { return Seven{s.x, s.y, s.z, s.e, s.i, s.j, s.k}; });
          }};
}

}  // namespace peers
