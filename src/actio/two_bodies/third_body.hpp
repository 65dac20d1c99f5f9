// A third body on a given orbit: the sun, or a planet that passes by, as a point.
//
// It is at R(t) from the barycentre, the first body at -(m2/M) X from there and the second at (m1/M) X. With
// d_i from body i to the third, and b_i = d_i/|d_i|, its potential on body i is
//
//     -G m3 [m_i/d_i + (tr I_i - 3 b_i.I_i b_i)/(2 d_i^3)].
//
// What moves the two against each other is the difference of two accelerations that are nearly equal; it is
// taken without the cancellation. Time goes on in drifts alone, so that a step is symplectic in the phase
// space with time and energy.
#pragma once

#include "actio/two_bodies/kepler_drift.hpp"
#include "actio/two_bodies/second_order_force.hpp"

namespace actio::bodies {

/// Elements of an orbit, of any eccentricity but 1.
struct OrbitElements {
  double half_axis;        ///< a, length; negative on a hyperbola
  double eccentricity;     ///< e
  double inclination = 0;  ///< rad
  double node = 0;         ///< of the ascending node, rad
  double pericentre = 0;   ///< argument of the pericentre, rad
  double time = 0;         ///< of the passage through the pericentre
};
/// Position and velocity in the pericentre.
/// @param mu  of the orbit, length^3/time^2
/// @throws NotFinite, OutsideDomain  where a number is none, e negative, or the signs of a and 1 - e differ
PointMotion<double> at_pericentre(OrbitElements const& orbit, double mu);

/// A point of mass m3 that moves about the barycentre of two bodies on an orbit of Kepler.
struct ThirdBody {
  double mass;                ///< m3
  PointMotion<double> start;  ///< position and velocity from the barycentre at `epoch`
  double epoch;               ///< time
  double mu;                  ///< of its orbit, length^3/time^2
};
/// A third body from the elements of its orbit.
/// @param mass   of the third body
/// @param inner  the mass of the two bodies
/// @throws NotFinite, OutsideDomain  where a number is none, or the mass not positive
ThirdBody third_body(double mass, OrbitElements const& orbit, double inner, double G);

/// What a third body adds to kicks.
class ThirdBodyForce {
 public:
  /// @param third         which moves on its orbit
  /// @param first,second  on which it acts
  /// @param G             constant of gravitation
  ThirdBodyForce(ThirdBody const& third, ExtendedBody const& first, ExtendedBody const& second, double G)
      : third_(third),
        first_(first.inertia),
        second_(second.inertia),
        m1_(first.mass()),
        m2_(second.mass()),
        strength_(G * third.mass) {}

  /// Adds to a kick at a time; the potential and 1/r are left.
  template <class T>
  void add_to(Kick<T>& kick, Three<T> const& X, Four<T> const& q1, Four<T> const& q2, double time) const {
    auto const moved =
        kepler_drift<double>(third_.start.position, third_.start.velocity, third_.mu, time - third_.epoch);
    double const M = m1_ + m2_, m = m1_ / M * m2_;
    Three<T> d1, d2;
    for (int i = 0; i < 3; ++i) {
      double const R = third_.start.position[i] + moved.position[i];
      d1[i] = R + m2_ / M * X[i], d2[i] = R - m1_ / M * X[i];
    }
    using std::sqrt;
    T const s1 = dot(d1, d1), s2 = dot(d2, d2), inverse = 1.0 / (s2 * sqrt(s2));
    // d2/|d2|^3 - d1/|d1|^3, by q = |d2|^2/|d1|^2 - 1 = X.(X - 2 d1)/|d1|^2.
    T const q = dot(X, Three<T>{X[0] - 2.0 * d1[0], X[1] - 2.0 * d1[1], X[2] - 2.0 * d1[2]}) / s1,
            stretch = q * (3.0 + q * (3.0 + q)) / (1.0 + (1.0 + q) * sqrt(1.0 + q));
    Three<T> const on_1 = body(d1, s1, q1, first_, kick.torque_1),
                   on_2 = body(d2, s2, q2, second_, kick.torque_2);
    for (int i = 0; i < 3; ++i)
      kick.force[i] += m * (on_2[i] / m2_ - on_1[i] / m1_ - strength_ * inverse * (X[i] + stretch * d1[i]));
  }

 private:
  /// The force on a body beyond that on its mass as a point; the torque is added.
  template <class T>
  Three<T> body(Three<T> const& d, T const& square, Four<T> const& q, Three<double> const& I,
                Three<T>& torque) const {
    using std::sqrt;
    T const rho = 1.0 / sqrt(square), cube = strength_ * (rho * rho * rho);
    Three<T> const b{d[0] * rho, d[1] * rho, d[2] * rho},
        u = seen_by(q, b), Iu{I[0] * u[0], I[1] * u[1], I[2] * u[2]}, turning = cross_product(u, Iu),
        in_space = turned_by(q, Iu);
    T const along = 1.5 * (I[0] + I[1] + I[2]) - 7.5 * dot(u, Iu);
    Three<T> force;
    for (int i = 0; i < 3; ++i) {
      torque[i] += 3.0 * cube * turning[i];
      force[i] = cube * rho * (along * b[i] + 3.0 * in_space[i]);
    }
    return force;
  }

  ThirdBody third_;
  Three<double> first_, second_;
  double m1_, m2_, strength_;
};

namespace detail {
/// A force with what a third body adds to it, where there is one.
template <class T, class Force>
struct InTime {
  Force const& force;
  ThirdBodyForce const* third;
  [[gnu::always_inline]] Kick<T> operator()(Three<T> const& X, Four<T> const& q1, Four<T> const& q2,
                                            double time) const {
    Kick<T> kick = force(X, q1, q2);
    if (third) [[unlikely]]
      third->add_to(kick, X, q1, q2, time);
    return kick;
  }
};
}  // namespace detail

}  // namespace actio::bodies
