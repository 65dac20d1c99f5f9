// Simple waves: exact motions of every isotropic medium, oblique to a mesh, before they break.
#pragma once

#include <array>
#include <cmath>
#include <functional>

namespace actio::testing {

/// A wave that moves in the direction n without changing the stretch q that each part of it has:
/// \f$\phi = X+n\,(\phi_1(s,t)-s)\f$ with \f$s = n.X\f$. On the line \f$s = s_0+c(q)\,t\f$ the stretch is
/// \f$q = q_0(s_0)\f$, the velocity is \f$v = -\int_1^qc\f$, and \f$\dot\phi_1 = v+cq\f$. For every isotropic
/// medium, whose speed of sound along n is \f$c(q) = \sqrt{W''(q)}\f$, until lines meet.
template <std::size_t d>
struct SimpleWave {
  using Place = std::array<double, d>;
  std::function<double(double)> c;  ///< speed of sound as a function of the stretch
  Place n;                          ///< unit vector
  double wave_length, amplitude;

  double stretch(double s) const { return 1 + amplitude * std::sin(2 * M_PI * s / wave_length); }
  /// \f$-\int_1^qc\f$ by Simpson's rule, whose error is below 1e-15 for such short ways.
  double velocity(double q) const {
    int const m = 64;
    double const h = (q - 1) / m;
    double sum = c(1) + c(q);
    for (int k = 1; k < m; ++k) sum += (k % 2 ? 4 : 2) * c(1 + k * h);
    return -sum * h / 3;
  }
  double place(double s, double t) const {
    double s0 = s - c(1) * t;
    for (int round = 0; round < 60; ++round) {
      double const f = s0 + c(stretch(s0)) * t - s, e = 1e-6;
      double const slope = 1 + t * (c(stretch(s0 + e)) - c(stretch(s0 - e))) / (2 * e);
      s0 -= f / slope;
      if (std::abs(f) < 1e-15) break;
    }
    double const q = stretch(s0),
                 start = s0 - amplitude * wave_length / (2 * M_PI) * std::cos(2 * M_PI * s0 / wave_length);
    return start + (velocity(q) + c(q) * q) * t;
  }
  Place at(Place const& X, double t) const {
    double const s = along(X), u = place(s, t) - s;
    Place out = X;
    for (std::size_t a = 0; a < d; ++a) out[a] += n[a] * u;
    return out;
  }
  Place velocity_at(Place const& X) const {
    double const v = velocity(stretch(along(X)));
    Place out;
    for (std::size_t a = 0; a < d; ++a) out[a] = n[a] * v;
    return out;
  }

 private:
  double along(Place const& X) const {
    double s = 0;
    for (std::size_t a = 0; a < d; ++a) s += n[a] * X[a];
    return s;
  }
};

}  // namespace actio::testing
