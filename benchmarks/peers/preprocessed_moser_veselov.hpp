// The discrete Moser-Veselov algorithm with preprocessed moments of inertia, of order 4 to 10, as Hairer and
// Vilmart published it (2006).
//
// In every step: the moments 1/I_i are replaced by s/I_i + d, polynomials in the energy H and in C = |M|^2/2;
// then the equation of Moser and Veselov,
//
//     (h/2) M = q0 I q + q x I q,
//
// is solved for the unit quaternion (q0, q) of the step by fixed-point iteration, the quaternion being
// normalized. The polynomials have the degrees 1, 2, 3, 4 in C and H for the orders 4, 6, 8, 10; their
// coefficients, which depend on the body alone, are worked out here in 50 digits, once, outside of the time
// that is measured.
#pragma once

#include <stdexcept>

#include "actio/fast_body/space/modified_inertia.hpp"
#include "actio/numbers/multiprecision.hpp"
#include "peers/quaternion.hpp"

namespace peers {

/// s and d as polynomials: \f$\sum_n (h/2)^{2n}\sum_m c_{nm}(2C)^{n-m}(2H)^m\f$.
class PreprocessingPolynomials {
 public:
  static constexpr int most = 5;

  /// @param order  2 to 10
  PreprocessingPolynomials(Task const& task, int order) : terms_(order / 2) {
    using actio::dec50, actio::bodies::Three;
    // For |M| = 1 the n-th term is a polynomial of degree n in 2H: interpolated at n + 1 energies.
    actio::bodies::Three<dec50> const I{dec50(task.I[0]), dec50(task.I[1]), dec50(task.I[2])};
    actio::bodies::InverseMoments<dec50> const body(I);
    std::array<dec50, most> energy;
    std::vector<actio::bodies::ModifiedInertiaSeries<dec50>> series;
    for (int k = 0; k < terms_; ++k) {
      dec50 const share = dec50(k) / most;
      energy[k] = body.J[2] + body.d13 * share;
      series.emplace_back(
          body, actio::bodies::Orbit<dec50>(body, {sqrt(share), dec50(0), sqrt(dec50(1 - share))}), terms_);
    }
    for (int n = 0; n < terms_; ++n) {
      s_[n] = interpolated(energy, n, [&](int k) { return series[k].s.coefficient(n); });
      d_[n] = interpolated(energy, n, [&](int k) { return series[k].d.coefficient(n); });
    }
  }

  /// The sum at one state.
  /// @param square  \f$(h/2)^2\f$
  void at(double twice_C, double twice_H, double square, double& s, double& d) const {
    s = d = 0;
    double power[most], scale = 1;
    power[0] = 1;
    for (int n = 1; n < terms_; ++n) power[n] = power[n - 1] * twice_C;
    for (int n = 0; n < terms_; ++n) {
      double of_s = s_[n][n], of_d = d_[n][n];
      for (int m = n - 1; m >= 0; --m)
        of_s = of_s * twice_H + s_[n][m] * power[n - m], of_d = of_d * twice_H + d_[n][m] * power[n - m];
      s += scale * of_s;
      d += scale * of_d;
      scale *= square;
    }
  }

 private:
  /// Coefficients of the polynomial of degree n through the first n + 1 values (Newton's divided
  /// differences).
  template <class Values>
  static std::array<double, most> interpolated(std::array<actio::dec50, most> const& x, int n,
                                               Values const& values) {
    using actio::dec50;
    std::array<dec50, most> difference, c;
    for (int k = 0; k <= n; ++k) difference[k] = values(k), c[k] = 0;
    for (int level = 1; level <= n; ++level)
      for (int k = n; k >= level; --k)
        difference[k] = (difference[k] - difference[k - 1]) / (x[k] - x[k - level]);
    c[0] = difference[n];
    for (int k = n - 1; k >= 0; --k) {
      for (int m = n; m > 0; --m) c[m] = c[m - 1] - x[k] * c[m];
      c[0] = difference[k] - x[k] * c[0];
    }
    std::array<double, most> out{};
    for (int k = 0; k <= n; ++k) out[k] = static_cast<double>(c[k]);
    return out;
  }

  int terms_;
  std::array<std::array<double, most>, most> s_{}, d_{};
};

/// One step.
class PreprocessedMoserVeselov {
 public:
  PreprocessedMoserVeselov(Task const& task, double h, int order) : polynomials_(task, order), half_(h / 2) {
    for (int i = 0; i < 3; ++i) J_[i] = 1 / task.I[i];
  }

  [[gnu::always_inline]] void operator()(Seven& y) const {
    double const x = y[0], v = y[1], z = y[2];
    double s, d;
    polynomials_.at(x * x + v * v + z * z, J_[0] * x * x + J_[1] * v * v + J_[2] * z * z, half_ * half_, s,
                    d);
    double const j0 = s * J_[0] + d, j1 = s * J_[1] + d, j2 = s * J_[2] + d;
    // With c = q/q0 the equation reads c_i = j_i (h/2) M_i (1 + |c|^2) - a_i c_j c_k, a_i = j_i
    // (1/j_k - 1/j_j).
    double const i0 = 1 / j0, i1 = 1 / j1, i2 = 1 / j2, a0 = j0 * (i2 - i1), a1 = j1 * (i0 - i2),
                 a2 = j2 * (i1 - i0);
    double const b0 = half_ * j0 * x, b1 = half_ * j1 * v, b2 = half_ * j2 * z;
    double c0 = b0, c1 = b1, c2 = b2, last = 1e300;
    for (int iteration = 0;; ++iteration) {
      if (iteration == 100) throw std::runtime_error("preprocessed Moser-Veselov: no convergence");
      double const sum = 1 + c0 * c0 + c1 * c1 + c2 * c2;
      double const n0 = b0 * sum - a0 * c1 * c2, n1 = b1 * sum - a1 * c2 * n0, n2 = b2 * sum - a2 * n0 * n1;
      double const change = std::abs(n0 - c0) + std::abs(n1 - c1) + std::abs(n2 - c2);
      c0 = n0, c1 = n1, c2 = n2;
      // Until rounding stops it.
      if (change <= 1e-16 * (std::abs(c0) + std::abs(c1) + std::abs(c2)) ||
          (change >= last && change < 1e-13))
        break;
      last = change;
    }
    double const square = 1 / (1 + c0 * c0 + c1 * c1 + c2 * c2), q0 = std::sqrt(square),
                 twice = 2 / half_ * square;
    // M' - M = -(2/(h/2)) q x I q
    y[0] = x - twice * (i2 - i1) * c1 * c2;
    y[1] = v - twice * (i0 - i2) * c2 * c0;
    y[2] = z - twice * (i1 - i0) * c0 * c1;
    turn_attitude(y, q0, q0 * c0, q0 * c1, q0 * c2);
    mend_attitude(y);
  }

 private:
  PreprocessingPolynomials polynomials_;
  std::array<double, 3> J_;
  double half_;
};

inline Method preprocessed_moser_veselov(int order) {
  return {"Hairer-Vilmart, order " + std::to_string(order), [order](Task const& task, double h) {
            return stepper(task.start(), PreprocessedMoserVeselov(task, h, order));
          }};
}

}  // namespace peers
