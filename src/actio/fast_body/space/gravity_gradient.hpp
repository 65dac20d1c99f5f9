// The torque of gravity on a body that is small against its distance from the centre.
//
// The near side is pulled more than the far side. With n the unit vector to the centre in the body frame, the
// torque and its potential are
//
//     tau = 3 mu/r^3 n x I n,        V = 3 mu/(2 r^3) n . I n.
//
// n stands still in space, or goes round it at a constant rate (a circular orbit: rate^2 = mu/r^3).
#pragma once

#include <Eigen/Geometry>

#include "actio/fast_body/space/free_body.hpp"

namespace actio::bodies {

/// \f$R^Tn\f$: a vector of space in the frame of a body with the attitude q.
[[gnu::always_inline]] inline Three<double> seen_from(Four<double> const& q, Three<double> const& n) {
  Three<double> const d{n[0] + n[0], n[1] + n[1], n[2] + n[2]};
  Three<double> const t{q[2] * d[2] - q[3] * d[1], q[3] * d[0] - q[1] * d[2], q[1] * d[1] - q[2] * d[0]};
  return {(n[0] - q[0] * t[0]) + (q[2] * t[2] - q[3] * t[1]),
          (n[1] - q[0] * t[1]) + (q[3] * t[0] - q[1] * t[2]),
          (n[2] - q[0] * t[2]) + (q[1] * t[1] - q[2] * t[0])};
}

/// The torque of gravity. Made by \ref gravity_gradient or \ref gravity_gradient_in_orbit, which check it.
class GravityGradient {
 public:
  Three<double> moments;  ///< of inertia, mass x length^2
  double strength;        ///< \f$3\mu/r^3\f$, 1/time^2
  Three<double> towards;  ///< unit vector to the centre at time 0, in space
  Three<double> ahead;    ///< where it moves to: a unit vector at right angles, in space
  double rate;            ///< at which it goes round, 1/time; zero where it stands still

  /// The unit vector to the centre, in space.
  Three<double> direction(double time) const {
    if (rate == 0) return towards;
    double const c = std::cos(rate * time), s = std::sin(rate * time);
    return {c * towards[0] + s * ahead[0], c * towards[1] + s * ahead[1], c * towards[2] + s * ahead[2]};
  }
  /// \f$3\mu/r^3\,(I_k-I_j)\f$, (i, j, k) cyclic; energy.
  Three<double> coefficients() const {
    return {strength * (moments[2] - moments[1]), strength * (moments[0] - moments[2]),
            strength * (moments[1] - moments[0])};
  }
  /// The torque on the body, in its own axes, energy. In time too where the direction moves.
  /// @param q  unit quaternion, body to space
  [[gnu::always_inline]] Three<double> operator()(Four<double> const& q, double time) const {
    // [gravity_gradient]
    Three<double> const c = coefficients();
    Three<double> const n = seen_from(q, direction(time));
    return {c[0] * (n[1] * n[2]), c[1] * (n[2] * n[0]), c[2] * (n[0] * n[1])};
    // [gravity_gradient]
  }
  /// V, energy.
  double potential(Element<SU2, double> const& attitude, double time = 0) const {
    auto const& q = attitude.value;
    Three<double> const n = seen_from({q[0], q[1], q[2], q[3]}, direction(time));
    return strength / 2 * (moments[0] * n[0] * n[0] + moments[1] * n[1] * n[1] + moments[2] * n[2] * n[2]);
  }
  /// The same torque in the axes in which the body is moved.
  GravityGradient in(MiddleAxisFrame const& frame) const {
    return {frame.counted(moments), strength, frame.counted(towards), frame.counted(ahead), rate};
  }
};

/// The torque of a centre that stands still in space.
/// @param inertia    of the body
/// @param strength   \f$3\mu/r^3\f$, 1/time^2, not negative
/// @param direction  to the centre, in space, of any length
/// @throws NotFinite, OutsideDomain  where a number is none, the strength negative or the direction zero
inline GravityGradient gravity_gradient(Inertia<3> const& inertia, double strength,
                                        Eigen::Vector3d const& direction) {
  if (!is_finite(strength) || !is_finite(direction))
    throw NotFinite("gravity gradient: strength or direction");
  if (strength < 0) throw OutsideDomain("gravity gradient", "the strength must not be negative", strength, 0);
  if (!(magnitude(direction) > 0))
    throw OutsideDomain("gravity gradient", "the direction must differ from zero", 0, 0);
  Eigen::Vector3d const n = direction.stableNormalized().normalized(), ahead = n.unitOrthogonal();
  auto const& I = inertia.moments;
  return {{I[0], I[1], I[2]}, strength, {n[0], n[1], n[2]}, {ahead[0], ahead[1], ahead[2]}, 0};
}
/// The torque in a circular orbit.
/// @param rate     mean motion, 1/time; \f$\mu/r^3\f$ is its square
/// @param towards  to the centre at time 0, in space, of any length
/// @param normal   of the orbit, about which the direction turns; not along `towards`
/// @throws NotFinite, OutsideDomain  where a number is none, or the two vectors do not span the orbit
inline GravityGradient gravity_gradient_in_orbit(Inertia<3> const& inertia, double rate,
                                                 Eigen::Vector3d const& towards,
                                                 Eigen::Vector3d const& normal) {
  if (!is_finite(rate) || !is_finite(normal))
    throw NotFinite("gravity gradient: mean motion or normal of the orbit");
  GravityGradient torque = gravity_gradient(inertia, 3 * rate * rate, towards);
  Eigen::Vector3d const n(torque.towards[0], torque.towards[1], torque.towards[2]),
      up = normal.stableNormalized();
  Eigen::Vector3d const ahead(up[1] * n[2] - up[2] * n[1], up[2] * n[0] - up[0] * n[2],
                              up[0] * n[1] - up[1] * n[0]);
  if (!(ahead.norm() > 1e-8))
    throw OutsideDomain(
        "gravity gradient",
        "the normal of the orbit must not be along the direction to the centre; sine of the angle",
        ahead.norm(), 1e-8);
  for (int i = 0; i < 3; ++i) torque.ahead[i] = ahead[i] / ahead.norm();
  torque.rate = rate;
  return torque;
}

}  // namespace actio::bodies
