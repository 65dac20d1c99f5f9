// Exact motions of incompressible media, by Runge and Kutta's classical step with an error below 1e-11.
#pragma once

#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "actio/linear_algebra/linear.hpp"

namespace actio::testing {

/// The solution after some time of y' = f(y), by so many steps; `each(y)` is called at the ends of all.
template <std::size_t n, class Rate, class Each>
std::array<double, n> integrated(std::array<double, n> y, double time, int steps, Rate const& rate,
                                 Each const& each) {
  double const h = time / steps;
  auto const plus = [](auto a, auto const& b, double by) {
    for (std::size_t k = 0; k < n; ++k) a[k] += by * b[k];
    return a;
  };
  each(y);
  for (int step = 0; step < steps; ++step) {
    auto const a = rate(y), b = rate(plus(y, a, h / 2)), c = rate(plus(y, b, h / 2)), d = rate(plus(y, c, h));
    for (std::size_t k = 0; k < n; ++k) y[k] += h / 6 * (a[k] + 2 * b[k] + 2 * c[k] + d[k]);
    each(y);
  }
  return y;
}
template <std::size_t n, class Rate>
std::array<double, n> integrated(std::array<double, n> const& y, double time, int steps, Rate const& rate) {
  return integrated(y, time, steps, rate, [](auto const&) {});
}

/// Cells that turn in a box [0, pi]^2 (Taylor and Green): steady.
struct TurningCells {
  static std::array<double, 2> velocity(std::array<double, 2> const& x) {
    return {std::sin(x[0]) * std::cos(x[1]), -std::cos(x[0]) * std::sin(x[1])};
  }
  static double pressure(std::array<double, 2> const& x) {
    return (std::cos(2 * x[0]) + std::cos(2 * x[1])) / 4;
  }
};

/// An annulus 1 <= R <= 2 whose surfaces are free, of density 1: r^2 = R^2 + s(t), and a particle turns by
/// theta' = Omega R^2/r^2. A fluid turns; a tube of modulus mu and energy mu/2 (|F|^2 - 2) rings.
struct Annulus {
  double mu, omega;    // the modulus; Omega
  double s = 0, rate;  // s and s'

  /// s'' from the Lagrangian L(s, s') = pi/8 s'^2 log(b/a) - U(s) with a = 1 + s, b = 4 + s.
  double acceleration(double q, double v) const {
    double const a = 1 + q, b = 4 + q, pi = std::numbers::pi;
    double const log = std::log(b / a), slope = 1 / b - 1 / a;
    // The integral of R^4/(R^2 + s)^2 over R^2.
    auto const whole = [q](double z) { return z - 2 * q * std::log(z) - q * q / z; };
    double const U =
        pi * mu / 2 * (std::log(4.0) - log - q * slope) - pi / 2 * omega * omega * (whole(b) - whole(a));
    return (-pi / 8 * v * v * slope - U) / (pi / 4 * log);
  }
  /// After some time: s, s', and the way of a particle about the axis for each of these R^2.
  struct State {
    double s, rate;
    std::vector<double> angle;
  };
  State after(double time, std::vector<double> const& squares) const {
    int const steps = 2000;
    std::vector<double> path;
    auto const end = integrated(
        std::array{s, rate}, time, steps,
        [this](auto const& y) {
          return std::array{y[1], acceleration(y[0], y[1])};
        },
        [&](auto const& y) { path.push_back(y[0]); });
    State out{end[0], end[1], {}};
    for (double const square : squares) {
      double sum = 0;  // by Simpson's rule
      for (int k = 0; k <= steps; ++k)
        sum += (k == 0 || k == steps ? 1 : k % 2 ? 4 : 2) * omega * square / (square + path[std::size_t(k)]);
      out.angle.push_back(sum * time / steps / 3);
    }
    return out;
  }
  /// The pressure at a radius: from the balance of momentum along it, and no stress on the inner surface.
  double pressure(State const& at, double r) const {
    double const more = acceleration(at.s, at.rate), inner = std::sqrt(1 + at.s);
    auto const slope = [&](double q) {
      double const square = q * q - at.s, turn = omega * square / (q * q);
      double const outwards = more / (2 * q) - at.rate * at.rate / (4 * q * q * q) - q * turn * turn;
      return outwards - mu * (square / (q * q) - q * q / square) / q;
    };
    int const parts = 200;
    double const h = (r - inner) / parts;
    double sum = 0;
    for (int k = 0; k <= parts; ++k) sum += (k == 0 || k == parts ? 1 : k % 2 ? 4 : 2) * slope(inner + k * h);
    double const square = r * r - at.s;
    return mu * square / (r * r) - sum * h / 3;
  }
};

/// A shell 1 <= R <= 2 of rubber with energy mu/2 (|F|^2 - 3), whose surfaces are free, of density 1:
/// r^3 = R^3 + s(t) (Knowles' sphere).
struct RubberShell {
  double mu, s = 0, rate;  // the modulus; s and s'

  /// s'' from the Lagrangian L(s, s') = M(s) s'^2/2 - U(s), M = 4 pi/9 (a^-1/3 - b^-1/3) with a = 1 + s and
  /// b = 8 + s, U the integral of the energy.
  double acceleration(double q, double v) const {
    double const pi = std::numbers::pi, a = 1 + q, b = 8 + q;
    double const M = 4 * pi / 9 * (1 / std::cbrt(a) - 1 / std::cbrt(b));
    double const slope = 4 * pi / 27 * (1 / (b * std::cbrt(b)) - 1 / (a * std::cbrt(a)));
    // dU/ds over Q = R^3 by Simpson's rule: W = mu/2 (x^-4/3 + 2 x^2/3 - 3) with x = 1 + s/Q.
    int const parts = 400;
    double pull = 0;
    for (int k = 0; k <= parts; ++k) {
      double const Q = 1 + 7.0 * k / parts, x = 1 + q / Q;
      double const dW = mu / 2 * (-4.0 / 3 * std::pow(x, -7.0 / 3) + 4.0 / 3 * std::pow(x, -1.0 / 3)) / Q;
      pull += (k == 0 || k == parts ? 1 : k % 2 ? 4 : 2) * dW;
    }
    pull *= 4 * pi / 3 * 7.0 / parts / 3;
    return -(pull + slope * v * v / 2) / M;
  }
  /// s after some time.
  double after(double time) const {
    return integrated(std::array{s, rate}, time, 400, [this](auto const& y) {
      return std::array{y[1], acceleration(y[0], y[1])};
    })[0];
  }
};

/// A drop without surface tension that stays an ellipsoid: phi = A(t)X with det A = 1, a geodesic of SL(d) in
/// the metric of the integral of velocities (Part I). A'' = m A^-T, P = m/2 (1 - |X|^2).
template <int d>
struct Drop {
  Matrix<double, d, d> A, V;

  static double pull(Matrix<double, d, d> const& A, Matrix<double, d, d> const& V) {
    auto const back = inverse_matrix(A);
    Matrix<double, d, d> const L = V * back, C = back * back.transpose();
    Matrix<double, d, d> const square = L * L;
    double sum = 0, trace = 0;
    for (int a = 0; a < d; ++a) sum += square(a, a), trace += C(a, a);
    return sum / trace;
  }
  /// After some time.
  Drop after(double time) const {
    std::array<double, 2 * d * d> y;
    std::copy_n(A.data(), d * d, y.begin()), std::copy_n(V.data(), d * d, y.begin() + d * d);
    y = integrated(y, time, 2000, [](auto const& now) {
      Drop at;
      std::copy_n(now.begin(), d * d, at.A.data()), std::copy_n(now.begin() + d * d, d * d, at.V.data());
      Matrix<double, d, d> const more = inverse_matrix(at.A).transpose() * pull(at.A, at.V);
      auto out = now;
      std::copy_n(at.V.data(), d * d, out.begin()), std::copy_n(more.data(), d * d, out.begin() + d * d);
      return out;
    });
    Drop out;
    std::copy_n(y.begin(), d * d, out.A.data()), std::copy_n(y.begin() + d * d, d * d, out.V.data());
    return out;
  }
};

}  // namespace actio::testing
