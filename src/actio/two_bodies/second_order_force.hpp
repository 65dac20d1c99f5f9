// The mutual potential of order 2 in closed form, as a kick: masses and moments of inertia are all it depends
// on.
//
//     V = -G [m1 m2/r + 1/(2 r^3) (m2 (tr I1 - 3 u.I1 u) + m1 (tr I2 - 3 w.I2 w))], u = R1^T n, w = R2^T n,
//
// with the direction n from the first body to the second. The torques are those of two gravity gradients,
// (3 G m2/r^3) u x I1 u and (3 G m1/r^3) w x I2 w.
#pragma once

#include "actio/fast_body/space/gravity_gradient.hpp"
#include "actio/two_bodies/extended_body.hpp"
#include "actio/two_bodies/mutual_potential.hpp"

namespace actio::bodies {

/// What a kick needs: the interaction without the attraction of the two masses as points, \f$Gm_1m_2/r\f$,
/// each vector where it is used.
template <class T>
struct Kick {
  T potential;        ///< energy
  T inverse;          ///< 1/r
  Three<T> force;     ///< on the second body, in space
  Three<T> torque_1;  ///< on the first body, in its axes
  Three<T> torque_2;  ///< on the second body, in its axes
};

/// \f$Rv\f$: a vector of a body with the attitude q, in space.
template <class T>
[[gnu::always_inline]] inline Three<T> turned_by(Four<T> const& q, Three<T> const& v) {
  Three<T> const a{q[1], q[2], q[3]}, t = cross_product(a, Three<T>{v[0] + v[0], v[1] + v[1], v[2] + v[2]}),
                                      c = cross_product(a, t);
  return {(v[0] + q[0] * t[0]) + c[0], (v[1] + q[0] * t[1]) + c[1], (v[2] + q[0] * t[2]) + c[2]};
}
/// \f$R^Tv\f$: a vector of space, in the axes of a body with the attitude q.
template <class T>
[[gnu::always_inline]] inline Three<T> seen_by(Four<T> const& q, Three<T> const& v) {
  return turned_by(Four<T>{q[0], -q[1], -q[2], -q[3]}, v);
}

/// The interaction of order 2 of two bodies.
/// @tparam C  double, or a pack of pairs of bodies
template <class C = double>
class SecondOrderForce {
 public:
  SecondOrderForce() = default;  // whose numbers are set lane by lane
  /// @param G  constant of gravitation
  SecondOrderForce(ExtendedBody const& first, ExtendedBody const& second, double G)
      : strength_1_(scaled(first.inertia, G * second.mass())),
        strength_2_(scaled(second.inertia, G * first.mass())) {}

  /// @param X      from the first centre of mass to the second, in space
  /// @param q1,q2  unit quaternions, bodies to space
  template <class T>
  [[gnu::always_inline]] Kick<T> operator()(Three<T> const& X, Four<T> const& q1, Four<T> const& q2) const {
    using std::sqrt;
    T const square = dot(X, X), rho = 1.0 / sqrt(square), cube = rho * rho * rho, fourth = cube * rho;
    Three<T> const n{X[0] * rho, X[1] * rho, X[2] * rho}, u = seen_by(q1, n), w = seen_by(q2, n);
    Three<T> const Iu{u[0] * strength_1_[0], u[1] * strength_1_[1], u[2] * strength_1_[2]},
        Iw{w[0] * strength_2_[0], w[1] * strength_2_[1], w[2] * strength_2_[2]};
    T const uu = dot(u, Iu), ww = dot(w, Iw), along = 7.5 * (uu + ww) - 1.5 * trace_;
    Three<T> const a = turned_by(q1, Iu), b = turned_by(q2, Iw), t1 = cross_product(u, Iu),
                   t2 = cross_product(w, Iw);
    Kick<T> kick;
    kick.potential = cube * (1.5 * (uu + ww) - 0.5 * trace_), kick.inverse = rho;
    for (int i = 0; i < 3; ++i) {
      kick.force[i] = fourth * (along * n[i] - 3.0 * (a[i] + b[i]));
      kick.torque_1[i] = 3.0 * cube * t1[i], kick.torque_2[i] = 3.0 * cube * t2[i];
    }
    return kick;
  }

 private:
  static Three<double> scaled(Three<double> const& I, double c) { return {c * I[0], c * I[1], c * I[2]}; }
  Three<C> strength_1_, strength_2_;  ///< G m2 I1 and G m1 I2
  C trace_ =
      strength_1_[0] + strength_1_[1] + strength_1_[2] + strength_2_[0] + strength_2_[1] + strength_2_[2];
};

}  // namespace actio::bodies
