// SU(2), as unit quaternions (scalar first).
//
// Coordinates are those of so(3): the quaternion (1, v/2) is what lies infinitely near the identity in the
// direction v, so the bracket is the cross product and the double cover of SO(3) is the identity in
// coordinates.
#pragma once

#include "actio/groups/rotation_logarithm.hpp"

namespace actio {

/// SU(2).
struct SU2 {
  static constexpr int dim = 3;
  static constexpr int dimension() { return 3; }
  template <class S>
  using Value = Matrix<S, 4, 1>;
  template <class S>
  using Vector = actio::Matrix<S, 3, 1>;

  template <class S>
  static Value<S> identity() { return {S(1), S(0), S(0), S(0)}; }
  template <class S>
  static Value<S> compose(Value<S> const& p, Value<S> const& q) {
    return {p[0] * q[0] - p[1] * q[1] - p[2] * q[2] - p[3] * q[3],
            p[0] * q[1] + q[0] * p[1] + p[2] * q[3] - p[3] * q[2],
            p[0] * q[2] + q[0] * p[2] + p[3] * q[1] - p[1] * q[3],
            p[0] * q[3] + q[0] * p[3] + p[1] * q[2] - p[2] * q[1]};
  }
  template <class S>
  static Value<S> inverse(Value<S> const& q) { return {q[0], -q[1], -q[2], -q[3]}; }
  /// \f$q v q^{-1}\f$, the rotation of v.
  template <class S>
  static Vector<S> Ad(Value<S> const& q, Vector<S> const& v) {
    Vector<S> const axis = q.template tail<3>();
    Vector<S> const t = cross(axis, v) * S(2);
    return v + t * q[0] + cross(axis, t);
  }
  template <class S>
  static Vector<S> bracket(Vector<S> const& v, Vector<S> const& w) { return cross(v, w); }
  /// The Cayley transform: \f$(1 + v/4)(1 - v/4)^{-1}\f$.
  template <class S>
  static Value<S> retract(Vector<S> const& v) {
    S const square = v.squaredNorm() / S(16);
    Vector<S> const axis = v / (S(2) * (S(1) + square));
    return {(S(1) - square) / (S(1) + square), axis[0], axis[1], axis[2]};
  }
  template <class S>
  static Value<S> near_identity(Vector<S> const& v) { return {S(1), v[0] / S(2), v[1] / S(2), v[2] / S(2)}; }
  template <Real S>
  static Value<S> exp(Vector<S> const& v) {
    S const square = v.squaredNorm() / S(4);
    Vector<S> const axis = v * (stumpff<1>(square) / S(2));
    return {stumpff<0>(square), axis[0], axis[1], axis[2]};
  }
  /// Of q, not of the rotation it covers: angles up to \f$2\pi\f$, the chart ending at \f$q = -1\f$.
  /// @throws OutsideDomain  at \f$q = -1\f$
  template <Real S>
  static Vector<S> log(Value<S> const& q) { return quaternion_logarithm(q); }
  /// Scaled to length 1.
  /// @throws OutsideDomain  where the length is not even near 1
  template <Real S>
  static Value<S> restore(Value<S> const& q) {
    using std::sqrt;
    S const square = q.squaredNorm();
    double const distance = std::abs(to_double(square) - 1);
    if (!(distance < 0.1))
      throw OutsideDomain("restore", "a quaternion near unit length is needed; |q^2 - 1|", distance, 0.1);
    return q / S(sqrt(square));
  }
};

}  // namespace actio
