// Symmetric splitting of the energy into the squares of the three components: each part turns the body about
// one axis, exactly.
#pragma once

#include "peers/quaternion.hpp"

namespace peers {

/// One step: about axes 1, 2 for half the time, 3 for the whole, 2, 1 for half.
class Splitting {
 public:
  Splitting(Task const& task, double h) {
    for (int i = 0; i < 3; ++i) quarter_[i] = h / (4 * task.I[i]);
  }
  [[gnu::always_inline]] void operator()(Seven& y) const {
    turn<0>(y, quarter_[0]);
    turn<1>(y, quarter_[1]);
    turn<2>(y, 2 * quarter_[2]);
    turn<1>(y, quarter_[1]);
    turn<0>(y, quarter_[0]);
    mend_attitude(y);
  }

 private:
  /// The momentum by -2 r M_i about axis i, the quaternion by the half of that.
  template <int i>
  [[gnu::always_inline]] static void turn(Seven& y, double r) {
    constexpr int j = (i + 1) % 3, k = (i + 2) % 3;
    double const angle = r * y[i], c = std::cos(angle), s = std::sin(angle), c2 = 1 - 2 * s * s,
                 s2 = 2 * s * c;
    double const u = y[j], v = y[k];
    y[j] = c2 * u + s2 * v;
    y[k] = c2 * v - s2 * u;
    // q (c, s e_i)
    double const q0 = y[3], qi = y[4 + i], qj = y[4 + j], qk = y[4 + k];
    y[3] = c * q0 - s * qi;
    y[4 + i] = c * qi + s * q0;
    y[4 + j] = c * qj + s * qk;
    y[4 + k] = c * qk - s * qj;
  }

  std::array<double, 3> quarter_;
};

inline Method splitting() {
  return {"splitting, order 2",
          [](Task const& task, double h) { return stepper(task.start(), Splitting(task, h)); }};
}

}  // namespace peers
