// The steady flow of Taylor and Green, cells of fluid that turn beside one another: velocity, motion of the
// particles, and paths and pressure in closed form.
//
// The velocity u = (sin y1 cos y2, -cos y1 sin y2) has the stream function sin y1 sin y2, which a particle
// keeps: k = sin X1 sin X2. Its path is given by Jacobi's elliptic functions of the parameter m = 1 - k^2,
// with the period 4 K(m), K the complete elliptic integral. The pressure is (cos 2 y1 + cos 2 y2)/4.
#pragma once

#include <gsl/gsl_sf_elljac.h>

#include <algorithm>
#include <cmath>

#include "actio/jets/jet.hpp"

using Place = actio::Vector<double, 2>;

// The flow: velocities at points (t, y).
struct Cells {
  template <class V>
  auto operator()(V const& at) const {
    using std::cos, std::sin;
    using T = typename V::Scalar;
    return actio::Matrix<T, 2, 1>(T(sin(at[1]) * cos(at[2])), T(-(cos(at[1]) * sin(at[2]))));
  }
};

// The motion of its particles: classical Runge-Kutta steps up to the plain time, and from there what
// infinitesimals t has by the Taylor polynomial.
struct Motion {
  static constexpr double step = 2e-3;
  template <class V>
  auto operator()(V const& x) const {
    using T = typename V::Scalar;
    using Y = actio::Matrix<T, 2, 1>;
    auto const u = [](Y const& y) { return Cells{}(actio::Matrix<T, 3, 1>(T(0), y[0], y[1])); };
    double const time = actio::base_value(x[0]);
    int const steps = std::max(1, static_cast<int>(std::ceil(std::abs(time) / step)));
    T const h(time / steps);
    Y y = x.template tail<2>();
    for (int i = 0; i < steps; ++i) {
      Y const a = u(y), b = u(y + a * T(h / 2.0)), c = u(y + b * T(h / 2.0)), d = u(y + c * h);
      y += (a + b * T(2.0) + c * T(2.0) + d) * T(h / 6.0);
    }
    T const s = x[0] - T(time);
    Y const velocity = u(y), further = u(y + velocity * s);
    return Y(y + (velocity + further) * T(s / 2.0));
  }
};
inline Place place_of(Place const& X, double t) { return Motion{}(actio::Vector<double, 3>(t, X[0], X[1])); }

// A particle's place by Jacobi's functions: cos y1 = sqrt(m) sn t, cos y2 = -sqrt(m) cd t, for one that
// starts on cos X1 = 0, cos X2 = -sqrt(m).
inline Place by_elliptic_functions(double k, double t) {
  double const m = 1 - k * k;
  double sn, cn, dn;
  gsl_sf_elljac_e(t, m, &sn, &cn, &dn);
  return {std::acos(std::sqrt(m) * sn), std::acos(-std::sqrt(m) * cn / dn)};
}
inline double period_of(double k) { return 4 * std::comp_ellint_1(std::sqrt(1 - k * k)); }

inline double pressure_at(Place const& y) { return (std::cos(2 * y[0]) + std::cos(2 * y[1])) / 4; }
