// The axes of a body, counted so that the middle moment of inertia belongs to the second, and a unit of inertia.
//
// One of the three ways to count cyclically does it, and these keep the orientation. Space is counted in the same way, so that a quaternion keeps its scalar part. The unit is a power
// of two: dividing by it rounds nothing. A rounded difference of two moments that are nearly equal would be another body.
#pragma once

#include <cmath>

#include "actio/numbers/errors.hpp"
#include "actio/fast_body/space/half_turn.hpp"

namespace actio {

/// To the axes in which free bodies are moved, and back.
class MiddleAxisFrame {
 public:
  /// @param moments  principal moments of inertia
  /// @throws NotFinite  where one is no number
  explicit MiddleAxisFrame(Eigen::Vector3d const& moments) {
    if (!is_finite(moments)) throw NotFinite("free body: moments of inertia");
    while (!between(moments[first_ % 3], moments[(first_ + 1) % 3], moments[(first_ + 2) % 3])) ++first_;
    int exponent = 0;
    std::frexp(magnitude(moments), &exponent);
    unit_ = std::ldexp(1.0, exponent);
    moments_ = enter(Eigen::Vector3d(moments / unit_));
  }

  /// Which axis of the body is counted first.
  int first() const { return first_; }
  /// The unit of inertia, a power of two near the largest moment.
  double unit() const { return unit_; }
  /// The moments in these axes and in this unit.
  Three<double> const& moments() const { return moments_; }

  /// A vector, to these axes.
  Three<double> enter(Eigen::Vector3d const& v) const { return {v[first_ % 3], v[(first_ + 1) % 3], v[(first_ + 2) % 3]}; }
  /// A quaternion, to these axes of body and space.
  Four<double> enter(Eigen::Vector4d const& q) const { return {q[0], q[1 + first_ % 3], q[1 + (first_ + 1) % 3], q[1 + (first_ + 2) % 3]}; }
  /// A vector, back to the axes of the body.
  Eigen::Vector3d leave(Three<double> const& v) const {
    Eigen::Vector3d out;
    for (int i = 0; i < 3; ++i) out[(i + first_) % 3] = v[i];
    return out;
  }
  /// A quaternion, back to the axes of body and space.
  Eigen::Vector4d leave(Four<double> const& q) const {
    Eigen::Vector4d out;
    out[0] = q[0];
    for (int i = 0; i < 3; ++i) out[1 + (i + first_) % 3] = q[1 + i];
    return out;
  }

 private:
  static bool between(double a, double b, double c) { return (a <= b && b <= c) || (a >= b && b >= c); }

  int first_ = 0;
  double unit_ = 1;
  Three<double> moments_;
};

}  // namespace actio
