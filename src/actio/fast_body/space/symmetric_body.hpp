// The free motion of a body with two equal moments, or three, in closed form.
//
// Let axis s be the axis of symmetry, J the inverse of the two equal moments and J + d that of the third. The
// velocity is J M + d M_s e_s: in space the body turns steadily about the momentum, and in the body the
// momentum turns steadily about e_s,
//
//     q(t) = q exp(t J M/2) exp(t d M_s e_s/2),          M(t) = M turned by -t d M_s about e_s.
//
// A sphere has d = 0. No function but sine and cosine is needed.
#pragma once

#include "actio/fast_body/space/short_flow.hpp"

namespace actio::bodies {

/// The axis of symmetry: 2 or 0 where the moments of the other two axes are equal to rounding, -1 where no
/// two are. The middle moment is the second.
///
/// Equal means within two epsilon of each other: taking such moments for equal turns the body by two epsilon
/// of the angle it has turned anyway.
inline int axis_of_symmetry(Three<double> const& moments) {
  double const same = 2 * std::numeric_limits<double>::epsilon() * std::abs(moments[1]);
  return std::abs(moments[0] - moments[1]) <= same ? 2 : std::abs(moments[2] - moments[1]) <= same ? 0 : -1;
}

/// The direction of the momentum of a symmetric body after a time.
/// @param axis  of symmetry, 0 or 2
/// @param t     time, times the magnitude of the momentum
template <class T>
Three<T> symmetric_motion(InverseMoments<T> const& body, int axis, Three<T> const& u, T const& t) {
  using std::cos, std::sin;
  T const turned = t * (axis == 2 ? -body.d23 : body.d12) * u[axis] / 2, co = cos(turned), si = sin(turned),
          cosine = (co - si) * (co + si), sine = 2 * si * co;
  int const i = (axis + 1) % 3, j = (axis + 2) % 3;
  Three<T> end = u;
  end[i] = cosine * u[i] + sine * u[j];
  end[j] = cosine * u[j] - sine * u[i];
  return end;
}

/// Direction and attitude. The quaternion is continuous in the time.
template <class T>
FrameState<T> symmetric_motion(InverseMoments<T> const& body, int axis, FrameState<T> const& start,
                               T const& t) {
  using std::cos, std::sin;
  Three<T> const& u = start.direction;
  T const slow = t * body.J[1] / 2, turned = t * (axis == 2 ? -body.d23 : body.d12) * u[axis] / 2,
          c = cos(slow), s = sin(slow);
  Four<T> about{cos(turned), T(0), T(0), T(0)};
  about[1 + axis] = sin(turned);
  return {symmetric_motion(body, axis, u, t),
          compose(compose(start.attitude, {c, s * u[0], s * u[1], s * u[2]}), about)};
}

}  // namespace actio::bodies
