// Munthe-Kaas' Runge-Kutta methods on bodies, written by hand: exponentials and actions in closed form, the
// velocity of a momentum and the bracket written out.
#pragma once

#include <array>
#include <cmath>

#include "actio/reduction/fehlberg.hpp"

namespace peers {

/// The classical method of order 4, in the rows of \ref actio::detail::Fehlberg.
struct ClassicalRows {
  static constexpr int stages = 4, order = 4;
  using Row = actio::detail::Fehlberg<double>::Row;
  std::array<Row, 5> rows{Row{}, Row{1, {0}, {0.5}}, Row{1, {1}, {0.5}}, Row{1, {2}, {1}},
                          Row{4, {0, 1, 2, 3}, {1 / 6., 1 / 3., 1 / 3., 1 / 6.}}};
};
struct FehlbergRows : actio::detail::Fehlberg<double> {
  static constexpr int order = 8;
};

/// A way of \f$\dot y = \xi(y)\cdot y\f$ over stretches of time, as those of any_equation.hpp: a
/// Runge-Kutta method for \f$\eta\f$, where \f$y = e^\eta\cdot y_0\f$ over a step and \f$\dot\eta =
/// \xi+\tfrac12[\eta,\xi]+\tfrac1{12}[\eta,[\eta,\xi]]-\dots\f$ up to as many brackets as the order needs.
/// @param motion  `velocity(y)`, `bracket(eta, xi)` and `act(eta, y)`, for velocities in the body
template <class Rows, class Motion, class Y, class Visit>
void munthe_kaas_steps(Motion const& motion, Y y, double stretch, int stretches, long steps,
                       Visit const& visit) {
  using Algebra = decltype(motion.velocity(y));
  static Rows const method;
  constexpr double coefficients[] = {1, 0.5, 1 / 12., 0, -1 / 720., 0, 1 / 30240.};
  double const h = stretch / static_cast<double>(steps);
  std::array<Algebra, Rows::stages> rates;
  Algebra eta;
  auto const combine = [&](auto const& row) {
    eta.fill(0);
    for (int k = 0; k < row.count; ++k) {
      double const c = h * row.weight[k];
      for (std::size_t i = 0; i < eta.size(); ++i) eta[i] += c * rates[row.of[k]][i];
    }
  };
  for (int k = 1; k <= stretches; ++k) {
    for (long s = 0; s < steps; ++s) {
      rates[0] = motion.velocity(y);
      for (int i = 1; i < Rows::stages; ++i) {
        combine(method.rows[i]);
        Algebra power = motion.velocity(motion.act(eta, y)), rate = power;
        for (int p = 1; p <= Rows::order - 2; ++p) {
          power = motion.bracket(eta, power);
          for (std::size_t a = 0; a < rate.size(); ++a) rate[a] += coefficients[p] * power[a];
        }
        rates[i] = rate;
      }
      combine(method.rows[Rows::stages]);
      y = motion.act(eta, y);
    }
    visit(k, y);
  }
}

using Three = std::array<double, 3>;
inline Three cross(Three const& a, Three const& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
inline Three sum(Three const& a, Three const& b, double c) {
  return {a[0] + c * b[0], a[1] + c * b[1], a[2] + c * b[2]};
}

/// The rotation by a vector, as a quaternion, and what it takes to shift along.
struct Turn {
  Three by;
  double cosine, sine_over;    ///< of half the angle; the sine over the angle
  double first = 0.5, second;  ///< (1 - cos)/angle^2, (angle - sin)/angle^3

  explicit Turn(double const* w) : by{w[0], w[1], w[2]} {
    double const square = w[0] * w[0] + w[1] * w[1] + w[2] * w[2], angle = std::sqrt(square);
    bool const none = square < 1e-30;
    cosine = std::cos(angle / 2), sine_over = none ? 0.5 : std::sin(angle / 2) / angle;
    first = 2 * sine_over * sine_over;
    second = none ? 1 / 6. : (1 - 2 * sine_over * cosine) / square;
  }
  /// A vector, turned back.
  Three back(Three const& v) const {
    Three const t = cross(by, v);
    return sum(sum(v, t, -2 * sine_over * cosine), cross(by, t), 2 * sine_over * sine_over);
  }
  /// A vector, turned by each part of the angle, on average.
  Three average(Three const& v) const {
    Three const t = cross(by, v);
    return sum(sum(v, t, first), cross(by, t), second);
  }
  /// Multiplies a quaternion by this one from the right.
  void after(double const* q, double* out) const {
    double const b = sine_over * by[0], c = sine_over * by[1], d = sine_over * by[2];
    out[0] = q[0] * cosine - q[1] * b - q[2] * c - q[3] * d;
    out[1] = q[0] * b + cosine * q[1] + q[2] * d - q[3] * c;
    out[2] = q[0] * c + cosine * q[2] + q[3] * b - q[1] * d;
    out[3] = q[0] * d + cosine * q[3] + q[1] * c - q[2] * b;
  }
};

/// The bracket of rigid motions, turns first.
inline std::array<double, 6> bracket_of_motions(std::array<double, 6> const& a,
                                                std::array<double, 6> const& b) {
  Three const u{a[0], a[1], a[2]}, v{b[0], b[1], b[2]},
      turn = cross(u, v), shift = sum(cross(u, {b[3], b[4], b[5]}), cross(v, {a[3], a[4], a[5]}), -1);
  return {turn[0], turn[1], turn[2], shift[0], shift[1], shift[2]};
}
/// Angular and linear momentum in the body after a motion; returns the shift.
template <class Y>
Three move_momenta(Turn const& turn, std::array<double, 6> const& eta, Y const& y, Y& out) {
  Three const linear{y[3], y[4], y[5]},
      shift = turn.average({eta[3], eta[4], eta[5]}),
      angular = turn.back(sum({y[0], y[1], y[2]}, cross(shift, linear), -1)), p = turn.back(linear);
  for (int i = 0; i < 3; ++i) out[i] = angular[i], out[3 + i] = p[i];
  return shift;
}

}  // namespace peers
