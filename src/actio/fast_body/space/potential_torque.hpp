// The torque of a potential on a rigid body, whatever function of the attitude and of time it is.
//
// With R the rotation matrix that takes the body to space, r_i its rows, which are the axes of space as the
// body sees them, and g_i the row of the derivatives of V by the entries of r_i, a turn by eta in the body
// changes each row by r_i x eta. So
//
//     dV = sum_i g_i . (r_i x eta),        tau = sum_i r_i x g_i,
//
// the torque that does the work -dV. How V is continued off the rotations does not matter: what a
// continuation adds is a symmetric matrix R^T g, of which tau, its skew part, knows nothing.
//
// V may depend on time. With time as a coordinate, whose momentum is minus the energy that is put in, kicks
// and drifts are exact flows still, a drift moves the time on, and a step of a torqued body is symplectic.
#pragma once

#include <array>
#include <utility>

#include "actio/fast_body/space/gravity_gradient.hpp"

namespace actio::bodies {

/// The entries of a matrix, row by row.
using NineEntries = std::array<double, 9>;

/// The rotation matrix of a unit quaternion, scalar part first.
inline NineEntries rotation_entries(Four<double> const& q) {
  double const x = q[1] + q[1], y = q[2] + q[2], z = q[3] + q[3];
  double const xx = x * q[1], yy = y * q[2], zz = z * q[3], xy = x * q[2], xz = x * q[3], yz = y * q[3],
               wx = x * q[0], wy = y * q[0], wz = z * q[0];
  return {1 - (yy + zz), xy - wz, xz + wy, xy + wz, 1 - (xx + zz), yz - wx, xz - wy, yz + wx, 1 - (xx + yy)};
}

/// \f$\sum_i r_i\times g_i\f$: the torque on the body in its own axes, energy.
/// @param rotation  body to space
/// @param slope     of the potential by the entries of the rotation, energy
inline Three<double> torque_of_slope(NineEntries const& rotation, NineEntries const& slope) {
  Three<double> torque{0, 0, 0};
  for (std::size_t i = 0; i < 9; i += 3) {
    double const *r = &rotation[i], *g = &slope[i];
    // [potential_torque]
    torque[0] += r[1] * g[2] - r[2] * g[1];
    torque[1] += r[2] * g[0] - r[0] * g[2];
    torque[2] += r[0] * g[1] - r[1] * g[0];
    // [potential_torque]
  }
  return torque;
}

/// The torque of a potential.
///
/// \snippet bodies.cpp potential_torque
/// @tparam Potential  (NineEntries const& rotation, double time, NineEntries& slope) -> double: V, energy,
///                    and its derivatives by the entries of the rotation, which takes the body to space
template <class Potential>
class PotentialTorque {
 public:
  /// @param potential  copied with each body that is under the torque
  explicit PotentialTorque(Potential potential) : potential_(std::move(potential)) {}

  /// The torque on the body, in its own axes, energy.
  /// @param q  unit quaternion, body to space
  Three<double> operator()(Four<double> const& q, double time) const {
    NineEntries const rotation = rotation_entries(q);
    NineEntries slope;
    potential_(rotation, time, slope);
    return torque_of_slope(rotation, slope);
  }
  /// V, energy.
  double potential(Element<SU2, double> const& attitude, double time = 0) const {
    auto const& q = attitude.value;
    NineEntries slope;
    return potential_(rotation_entries({q[0], q[1], q[2], q[3]}), time, slope);
  }
  /// The function that it comes from.
  Potential const& function() const { return potential_; }

 private:
  Potential potential_;
};

}  // namespace actio::bodies
