// A submarine in still water: an ellipsoid whose inertia the water has a share in, and its motion by
// Kirchhoff's equations.
//
// The water that is pushed aside makes a body heavier sideways than ahead. Coordinates of the algebra of
// SE(3): turning, then gliding, in the body frame.
#pragma once

#include <cmath>

#include "actio/groups/motions.hpp"
#include "actio/variational/euler_poincare.hpp"

using Vector6d = actio::Matrix<double, 6, 1>;

// Lamb's integrals of an ellipsoid in an ideal fluid: abc times the integral over u > 0 of du / ((a_i^2 + u)
// sqrt(prod (a_k^2 + u))). They add up to 2.
inline actio::Vector<double, 3> lamb(actio::Vector<double, 3> const& half_axes) {
  actio::Vector<double, 3> sum = actio::Vector<double, 3>::Zero(), squares = half_axes.cwiseAbs2();
  for (double s = -4; s < 4; s += 0.01) {  // u = exp(2 sinh s): the trapezoidal rule is exact to rounding
    double const u = std::exp(2 * std::sinh(s)), du = 2 * std::cosh(s) * u * 0.01;
    actio::Vector<double, 3> const d = squares + actio::Vector<double, 3>::Constant(u);
    sum += half_axes.prod() * du / std::sqrt(d.prod()) * d.cwiseInverse();
  }
  return sum;
}

// 4 m long, 1.6 m wide, 1 m high, as heavy as the water it displaces, its mass spread evenly. Inertia with
// that of the water: Lamb, Hydrodynamics, 114 and 115.
struct Submarine {
  actio::Vector<double, 3> half_axes{2.0, 0.8, 0.5};     // m
  double mass = 1000 * 4 * M_PI / 3 * half_axes.prod();  // kg
  Vector6d inertia;                                      // kg m^2 of turning, kg of gliding
  // ahead at 1 m/s, turning a little about each axis; rad/s, m/s
  Vector6d cast_off{{0.15, 0.1, 0.06, 1.0, 0.1, 0.05}};

  Submarine() {
    actio::Vector<double, 3> const b = half_axes.cwiseAbs2(), alpha = lamb(half_axes);
    for (int i = 0; i < 3; ++i) {
      int const j = (i + 1) % 3, k = (i + 2) % 3;
      double const less = b[j] - b[k], sum = b[j] + b[k], tilt = alpha[k] - alpha[j];
      inertia[i] = mass / 5 * (sum + less * less * tilt / (2 * less - sum * tilt));
      inertia[3 + i] = mass * (1 + alpha[i] / (2 - alpha[i]));
    }
  }
  // Its Lagrangian, a function of turning and gliding alone.
  auto operator()(auto const& xi) const {
    auto sum = xi.coordinates[0] * xi.coordinates[0] * inertia[0];
    for (int i = 1; i < 6; ++i) sum += xi.coordinates[i] * xi.coordinates[i] * inertia[i];
    return sum / 2.0;
  }
};

// What Runge-Kutta steps: a configuration, and its velocity in the body frame.
struct Motion {
  actio::Matrix<double, 4, 4> g = actio::Matrix<double, 4, 4>::Identity();
  Vector6d xi;
  Motion operator+(Motion const& b) const { return {g + b.g, xi + b.xi}; }
};
inline Motion operator*(double s, Motion const& a) { return {s * a.g, s * a.xi}; }
inline Motion runge_kutta(Submarine const& submarine, Motion const& x, double h) {
  auto const rate = [&](Motion const& m) {  // Kirchhoff's equations
    return Motion{m.g * actio::SE<3>::hat(m.xi),
                  actio::euler_poincare_acceleration_left(submarine, actio::velocity(actio::SE<3>{}, m.xi))
                      .coordinates};
  };
  Motion const k1 = rate(x), k2 = rate(x + h / 2 * k1), k3 = rate(x + h / 2 * k2), k4 = rate(x + h * k3);
  return x + h / 6 * (k1 + 2 * k2 + 2 * k3 + k4);
}
