// The torque of a uniform field of gravity on a body that is held at a point.
//
// With the lever p = m |g| chi, weight times centre of mass, and n the direction of gravity in the body
// frame, torque and potential are
//
//     tau = p x n,        V = -p.n.
//
// A step of a torqued body, half a kick, a drift, half a kick, is that of a variational integrator. Its
// discrete Lagrangian is
//
//     L_d(g0, g1) = S(g0, g1) - h/2 (V(g0) + V(g1)),
//
// S the action of the free motion from g0 to g1 in the time h, and the potential by the trapezoid. For -D1 S
// and D2 S are the momenta with which the drift begins and ends, so that
// -D1 L_d and D2 L_d are these with half a kick more on either side: the discrete Euler-Lagrange equations
// match the momenta node by node. Compositions such as that of Blanes and Moan are the same with more nodes.
// So the motion is symplectic, and the momentum map of the symmetry is conserved: V is invariant under
// rotations about the vertical, so the momentum about the vertical is constant.
#pragma once

#include <Eigen/Core>

#include "actio/fast_body/space/gravity_gradient.hpp"

namespace actio::bodies {

/// The torque of a uniform field. Made by \ref uniform_gravity, which checks it.
class UniformGravity {
 public:
  Three<double> lever;    ///< \f$m|g|\chi\f$, in the body; energy
  Three<double> towards;  ///< unit vector along gravity, in space

  /// The torque on the body about the fixed point, in its own axes, energy.
  /// @param q  unit quaternion, body to space
  [[gnu::always_inline]] Three<double> operator()(Four<double> const& q, double) const {
    // [uniform_gravity]
    Three<double> const n = seen_from(q, towards);
    return {lever[1] * n[2] - lever[2] * n[1], lever[2] * n[0] - lever[0] * n[2],
            lever[0] * n[1] - lever[1] * n[0]};
    // [uniform_gravity]
  }
  /// V, energy; zero with the centre of mass as high as the fixed point.
  double potential(Element<SU2, double> const& attitude) const {
    auto const& q = attitude.value;
    return -dot(lever, seen_from({q[0], q[1], q[2], q[3]}, towards));
  }
  /// The same torque in the axes in which the body is moved.
  UniformGravity in(MiddleAxisFrame const& frame) const {
    return {frame.enter(Eigen::Vector3d(lever[0], lever[1], lever[2])), frame.counted(towards)};
  }
};

/// The torque of a uniform field.
///
/// \snippet bodies.cpp torqued_body
/// @param lever    mass times the magnitude of gravity times the way from the fixed point to the centre of
///                 mass, in the axes of the body; energy
/// @param gravity  of any length but zero, in space
/// @throws NotFinite, OutsideDomain  where a number is none, or the direction is zero
inline UniformGravity uniform_gravity(Eigen::Vector3d const& lever, Eigen::Vector3d const& gravity) {
  if (!is_finite(lever) || !is_finite(gravity)) throw NotFinite("uniform gravity: lever or direction");
  if (!(magnitude(gravity) > 0))
    throw OutsideDomain("uniform gravity", "the direction must differ from zero", 0, 0);
  Eigen::Vector3d const n = gravity.stableNormalized().normalized();
  return {{lever[0], lever[1], lever[2]}, {n[0], n[1], n[2]}};
}

}  // namespace actio::bodies
