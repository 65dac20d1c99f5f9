// The inertia of a body in space in a frame of any choice: principal moments, and the axes that they belong
// to.
#pragma once

#include <Eigen/Core>

#include "actio/rigid_body/inertia.hpp"

namespace actio {

/// The inertia of a body in a frame of any choice, by its principal moments and axes.
///
/// An `Inertia<3>` alone is that of a body whose frame is that of its principal axes.
struct PrincipalInertia {
  Inertia<3> inertia;  ///< along the principal axes
  /// principal axes as columns, in the frame of the body; a rotation
  Eigen::Matrix3d axes = Eigen::Matrix3d::Identity();

  /// No body: to be assigned.
  PrincipalInertia() = default;
  /// The frame is that of the principal axes.
  PrincipalInertia(Inertia<3> const& along_axes) : inertia(along_axes) {}
  /// @param along  principal axes as columns, in the frame of the body; a rotation
  PrincipalInertia(Inertia<3> const& along_axes, Eigen::Matrix3d const& along)
      : inertia(along_axes), axes(along) {}

  /// Whether the frame of the body is another than that of the principal axes.
  bool is_turned() const { return axes != Eigen::Matrix3d::Identity(); }
  /// I in the frame of the body; mass x length^2.
  Eigen::Matrix3d tensor() const { return axes * inertia.moments.asDiagonal() * axes.transpose(); }
  /// \f$I^{-1}\f$ in the frame of the body; 1/(mass x length^2).
  Eigen::Matrix3d inverse_tensor() const {
    return axes * Eigen::Vector3d(inertia.moments).cwiseInverse().asDiagonal() * axes.transpose();
  }
};

/// Principal moments and axes of a full tensor of inertia.
///
/// \snippet bodies.cpp principal_inertia
/// @param tensor  3 by 3, symmetric, mass x length^2 (products of inertia with the sign they have in the
///                tensor)
/// @throws NotFinite          where an entry is no number
/// @throws OutsideDomain      where the tensor is not symmetric up to rounding
/// @throws UnphysicalInertia  where it is not positive definite or breaks the triangle inequality
PrincipalInertia principal_inertia(Eigen::Matrix3d const& tensor);

/// \f$M = I\omega\f$, both in the frame of the body; energy x time.
inline Momentum<SO<3>, double> body_momentum(PrincipalInertia const& inertia,
                                             Velocity<SO<3>, double> const& omega) {
  return {{}, inertia.tensor() * Eigen::Vector3d(omega.coordinates)};
}
/// \f$\omega = I^{-1}M\f$, both in the frame of the body; 1/time.
inline Velocity<SO<3>, double> body_velocity(PrincipalInertia const& inertia,
                                             Momentum<SO<3>, double> const& m) {
  return {{}, inertia.inverse_tensor() * Eigen::Vector3d(m.components)};
}
/// \f$\tfrac12\langle M, I^{-1}M\rangle\f$, M in the frame of the body; energy.
inline double kinetic_energy(PrincipalInertia const& inertia, Momentum<SO<3>, double> const& m) {
  return pair(m, body_velocity(inertia, m)) / 2;
}

}  // namespace actio
