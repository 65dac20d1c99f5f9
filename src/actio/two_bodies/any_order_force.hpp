// The mutual potential of any order as a kick: the general class, in the axes of space and of the bodies.
#pragma once

#include "actio/two_bodies/second_order_force.hpp"

namespace actio::bodies {

/// The rows of the rotation of a unit quaternion.
template <class T>
[[gnu::always_inline]] inline std::array<Three<T>, 3> rotation_rows(Four<T> const& q) {
  T const xx = q[1] * q[1], yy = q[2] * q[2], zz = q[3] * q[3], xy = q[1] * q[2], yz = q[2] * q[3],
          zx = q[3] * q[1], wx = q[0] * q[1], wy = q[0] * q[2], wz = q[0] * q[3];
  return {{{1.0 - 2.0 * (yy + zz), 2.0 * (xy - wz), 2.0 * (zx + wy)},
           {2.0 * (xy + wz), 1.0 - 2.0 * (zz + xx), 2.0 * (yz - wx)},
           {2.0 * (zx - wy), 2.0 * (yz + wx), 1.0 - 2.0 * (xx + yy)}}};
}
/// \f$q_1^{-1}q_2\f$ of unit quaternions.
template <class T>
[[gnu::always_inline]] inline Four<T> relative_attitude(Four<T> const& q1, Four<T> const& q2) {
  return compose(Four<T>{q1[0], -q1[1], -q1[2], -q1[3]}, q2);
}

/// The interaction of any order.
template <class T = double>
class AnyOrderForce {
 public:
  /// @param order  N
  /// @param G      constant of gravitation
  /// @throws OutsideDomain  where the order is negative or above that of the moments
  AnyOrderForce(ExtendedBody const& first, ExtendedBody const& second, int order, double G)
      : potential_(first.moments.over<T>(), second.moments.over<T>(), order, T(G)),
        strength_(G * first.mass() * second.mass()) {}

  /// @param X      from the first centre of mass to the second, in space
  /// @param q1,q2  unit quaternions, bodies to space
  Kick<T> operator()(Three<T> const& X, Four<T> const& q1, Four<T> const& q2) const {
    using std::sqrt;
    Three<T> const r = seen_by(q1, X);
    Four<T> const q = relative_attitude(q1, q2);
    auto const all = potential_(r, rotation_rows(q));
    T const rho = 1.0 / sqrt(dot(r, r)), monopole = strength_ * (rho * rho * rho);
    Three<T> rest = all.force;
    for (int i = 0; i < 3; ++i) rest[i] += monopole * r[i];
    return {all.potential + strength_ * rho, rho, turned_by(q1, rest), all.torque_1,
            seen_by(q, all.torque_2)};
  }

 private:
  MutualPotential<T> potential_;
  double strength_;
};

}  // namespace actio::bodies
