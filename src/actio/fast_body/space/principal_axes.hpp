// From the frame in which a body is described to its principal axes, and back.
//
// The momentum is turned by the transpose of the axes A, M -> A^T M. The attitude is composed with A as a
// quaternion, q -> q a, and then takes the principal axes to space. A body that is described along its
// principal axes is left as it is, to the bit.
#pragma once

#include <Eigen/Core>

#include "actio/groups/unit_quaternions.hpp"
#include "actio/rigid_body/principal_inertia.hpp"

namespace actio::bodies {

/// To the principal axes of a body, and back to its frame.
class PrincipalAxes {
 public:
  /// @param axes  as columns, in the frame of the body
  /// @throws NotFinite, OutsideDomain  where an entry is no number, or the axes are no rotation to 1e-9
  explicit PrincipalAxes(Eigen::Matrix3d const& axes);

  /// A vector of the body, along the principal axes.
  Eigen::Vector3d enter(Eigen::Vector3d const& v) const {
    return turned_ ? Eigen::Vector3d(axes_.transpose() * v) : v;
  }
  /// An attitude, principal axes to space.
  Eigen::Vector4d enter(Eigen::Vector4d const& q) const {
    return turned_ ? Eigen::Vector4d(SU2::compose<double>(q, turn_)) : q;
  }
  /// A vector along the principal axes, in the frame of the body.
  Eigen::Vector3d leave(Eigen::Vector3d const& v) const { return turned_ ? Eigen::Vector3d(axes_ * v) : v; }
  /// An attitude of the principal axes, as that of the frame of the body.
  Eigen::Vector4d leave(Eigen::Vector4d const& q) const {
    return turned_ ? Eigen::Vector4d(SU2::compose<double>(q, SU2::inverse<double>(turn_))) : q;
  }

  /// Whether the two frames differ.
  bool turned() const { return turned_; }

 private:
  // Entry by entry, one branch: most bodies are described along their principal axes.
  static bool is_identity(Eigen::Matrix3d const& a) {
    double const* e = a.data();
    return (e[0] == 1) & (e[4] == 1) & (e[8] == 1) & (e[1] == 0) & (e[2] == 0) & (e[3] == 0) & (e[5] == 0) &
           (e[6] == 0) & (e[7] == 0);
  }

  bool turned_;
  Eigen::Matrix3d axes_;  // set where turned_
  Eigen::Vector4d turn_ = {1, 0, 0, 0};
};

}  // namespace actio::bodies
