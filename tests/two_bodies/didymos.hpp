// The binary asteroid Didymos and Dimorphos as two ellipsoids, with the start for which figures are known;
// and its motion to order 2 by somebody else's integrator, from the equations of motion in velocities.
#pragma once

#include <Eigen/Geometry>

#include <numbers>

#include "actio/two_bodies/two_bodies.hpp"
#include "witness/reference_solution.hpp"

namespace actio::testing {

using namespace actio::bodies;
using Eigen::Quaterniond;
using Eigen::Vector3d;

inline Element<SU2, double> element(Quaterniond const& q) {
  return {SU2{}, Eigen::Vector4d(q.w(), q.x(), q.y(), q.z())};
}
inline Quaterniond quaternion(Element<SU2, double> const& q) {
  return {q.value[0], q.value[1], q.value[2], q.value[3]};
}
inline double mass_of_ellipsoid(double density, std::array<double, 3> const& a) {
  return 4 * std::numbers::pi / 3 * density * a[0] * a[1] * a[2];
}

/// 1195 m apart; the primary is tilted by 3 degrees and turns about its own axis in 2.26 h, the moon is
/// rolled by 10 degrees and turns about the axis of the orbit once in a revolution.
struct Didymos {
  static constexpr double G = 6.674e-11, distance = 1195, speed = 0.1735;
  ExtendedBody primary, moon;
  double n, radian;  ///< mean motion and its inverse
  TwoBodyState start;
  Quaterniond q1{Eigen::AngleAxisd(std::numbers::pi / 60, Vector3d::UnitY())},
      q2{Eigen::AngleAxisd(std::numbers::pi / 18, Vector3d::UnitX())};
  Vector3d omega_1, omega_2;

  explicit Didymos(int order = 4)
      : primary(ellipsoid_body(mass_of_ellipsoid(2170, {400, 395, 340}), {400, 395, 340}, order)),
        moon(ellipsoid_body(mass_of_ellipsoid(2400, {85, 73, 63}), {85, 73, 63}, order)),
        n(std::sqrt(G * (primary.mass() + moon.mass()) / std::pow(distance, 3))),
        radian(1 / n),
        omega_1(0, 0, 2 * std::numbers::pi / (2.26 * 3600)),
        omega_2(q2.conjugate() * Vector3d(0, 0, n)) {
    start = state_of_velocities(primary, moon, {distance, 0, 0}, {0, speed, 0}, element(q1), omega_1,
                                element(q2), omega_2);
  }
  TwoBodies pair(double step, PairMethod method = kepler_splitting(), int order = 2) const {
    return TwoBodies(primary, moon, start,
                     {.order = order, .step = step, .method = std::move(method), .G = G});
  }
  /// The place of the moon in units of the first distance.
  static Vector3d place(TwoBodyState const& s) { return s.position / distance; }
  /// The same as the primary sees it.
  static Vector3d place_seen(TwoBodyState const& s) {
    return quaternion(s.first.attitude).conjugate() * place(s);
  }
};

/// Half the angle between two attitudes, about.
inline double apart(Element<SU2, double> const& p, Element<SU2, double> const& q) {
  return std::min((p.value - q.value).norm(), (p.value + q.value).norm());
}

/// The state after a time by the Prince-Dormand pair: x' = v, m v' = F, I w' = I w x w + t, q' = q w/2, with
/// the force and the torques of order 2 as sums over matrices. Lengths count in first distances, times in
/// radians.
inline TwoBodyState solved(Didymos const& d, double time) {
  using Twenty = actio::Vector<double, 20>;
  double const L = Didymos::distance, T = d.radian, m1 = d.primary.mass(), m2 = d.moon.mass(), M = m1 + m2;
  Vector3d const I1 = Vector3d(d.primary.inertia[0], d.primary.inertia[1], d.primary.inertia[2]) / (L * L),
                 I2 = Vector3d(d.moon.inertia[0], d.moon.inertia[1], d.moon.inertia[2]) / (L * L);
  // In these units G (m1 + m2) is 1. The axes of both bodies are counted by their moments.
  Eigen::Matrix3d const A1 = d.primary.axes, A2 = d.moon.axes;
  auto const equations = [&](double, Twenty const& y) {
    Vector3d const X = y.head<3>(), w1 = y.segment<3>(6), w2 = y.segment<3>(9);
    Eigen::Vector4d const p = y.segment<4>(12), q = y.segment<4>(16);
    Eigen::Matrix3d const R1 = Quaterniond(p[0], p[1], p[2], p[3]).toRotationMatrix() * A1,
                          R2 = Quaterniond(q[0], q[1], q[2], q[3]).toRotationMatrix() * A2,
                          S1 = R1 * I1.asDiagonal() * R1.transpose(),
                          S2 = R2 * I2.asDiagonal() * R2.transpose();
    double const r = X.norm();
    Vector3d const N = X / r;
    auto const pull = [&](Eigen::Matrix3d const& S) {
      return Vector3d(1.5 / std::pow(r, 4) * ((5 * N.dot(S * N) - S.trace()) * N - 2 * S * N));
    };
    Vector3d const force = -N / (r * r) + pull(S1) / m1 + pull(S2) / m2;
    Vector3d const t1 = 3 * m2 / M / std::pow(r, 3) * N.cross(S1 * N),
                   t2 = 3 * m1 / M / std::pow(r, 3) * N.cross(S2 * N);
    auto const spin = [](Eigen::Matrix3d const& R, Vector3d const& I, Eigen::Matrix3d const& A,
                         Vector3d const& w, Vector3d const& torque) {
      Vector3d const u = A.transpose() * w, t = R.transpose() * torque;
      return Vector3d(A * (I.cwiseProduct(u).cross(u) + t).cwiseQuotient(I));
    };
    auto const turn = [](Eigen::Vector4d const& e, Vector3d const& w) {
      Eigen::Vector4d rate;
      rate << -0.5 * e.tail<3>().dot(w), 0.5 * (e[0] * w + e.tail<3>().cross(w));
      return rate;
    };
    Twenty rate;
    rate << y.segment<3>(3), force, spin(R1, I1, A1, w1, t1), spin(R2, I2, A2, w2, t2), turn(p, w1),
        turn(q, w2);
    return rate;
  };
  Twenty y;
  y << Vector3d(1, 0, 0), Vector3d(0, Didymos::speed * T / L, 0), d.omega_1 * T, d.omega_2 * T, d.q1.w(),
      d.q1.vec(), d.q2.w(), d.q2.vec();
  Twenty const end = reference_solution(equations, y, 0, time / T, 2e-16);
  auto const q = [&](int at) {
    return element(Quaterniond(end[at], end[at + 1], end[at + 2], end[at + 3]).normalized());
  };
  return state_of_velocities(d.primary, d.moon, end.head<3>() * L, end.segment<3>(3) * L / T, q(12),
                             end.segment<3>(6) / T, q(16), end.segment<3>(9) / T);
}

}  // namespace actio::testing
