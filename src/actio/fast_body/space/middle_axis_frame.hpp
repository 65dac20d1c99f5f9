// The principal axes of a body, counted so that the middle moment of inertia belongs to the second, and a
// unit of inertia.
//
// The way there from the frame of the body is one rotation, which is composed of the turn to the principal
// axes and of the counting. One of the three ways to count cyclically does it, and these keep the
// orientation. Space is counted in the same way, so that a quaternion keeps its scalar part. The unit is a
// power of two: dividing by it rounds nothing. A rounded difference of two moments that are nearly equal
// would be another body.
#pragma once

#include <Eigen/Core>

#include <cmath>

#include "actio/fast_body/space/half_turn.hpp"
#include "actio/fast_body/space/principal_axes.hpp"

namespace actio::bodies {

/// To the axes in which free bodies are moved, and back to the frame of the body.
class MiddleAxisFrame {
 public:
  /// @param inertia  of the body, in its frame
  /// @throws NotFinite, OutsideDomain  where a moment is no number, or the axes are no rotation
  explicit MiddleAxisFrame(PrincipalInertia const& inertia);

  /// Which axis of the body is counted first.
  int first() const { return first_; }
  /// The unit of inertia, a power of two near the largest moment.
  double unit() const { return unit_; }
  /// The moments in these axes and in this unit.
  Three<double> const& moments() const { return moments_; }

  /// The turn between the frame of the body and its principal axes.
  PrincipalAxes const& axes() const { return axes_; }

  /// A vector of space, or numbers that belong to the principal axes one by one, in the order of these axes.
  template <class V>
  Three<double> counted(V const& v) const {
    return {v[first_ % 3], v[(first_ + 1) % 3], v[(first_ + 2) % 3]};
  }
  /// A vector of the body, to these axes.
  Three<double> enter(Eigen::Vector3d const& v) const { return counted(axes_.enter(v)); }
  /// An attitude, to these axes of body and space.
  Four<double> enter(Eigen::Vector4d const& attitude) const {
    Eigen::Vector4d const q = axes_.enter(attitude);
    return {q[0], q[1 + first_ % 3], q[1 + (first_ + 1) % 3], q[1 + (first_ + 2) % 3]};
  }
  /// A vector, back to the frame of the body.
  Eigen::Vector3d leave(Three<double> const& v) const {
    Eigen::Vector3d out;
    for (int i = 0; i < 3; ++i) out[(i + first_) % 3] = v[i];
    return axes_.leave(out);
  }
  /// An attitude, back to the frame of the body and to the axes of space.
  Eigen::Vector4d leave(Four<double> const& q) const;

 private:
  static bool between(double a, double b, double c) { return (a <= b && b <= c) || (a >= b && b >= c); }

  PrincipalAxes axes_;
  int first_ = 0;
  double unit_ = 1;
  Three<double> moments_;
};

}  // namespace actio::bodies
