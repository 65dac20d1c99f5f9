#include "actio/fast_body/space/middle_axis_frame.hpp"

namespace actio::bodies {

MiddleAxisFrame::MiddleAxisFrame(PrincipalInertia const& inertia) : axes_(inertia.axes) {
  Eigen::Vector3d const moments = inertia.inertia.moments;
  if (!is_finite(moments)) throw NotFinite("free body: moments of inertia");
  while (!between(moments[first_ % 3], moments[(first_ + 1) % 3], moments[(first_ + 2) % 3])) ++first_;
  int exponent = 0;
  std::frexp(magnitude(moments), &exponent);
  unit_ = std::ldexp(1.0, exponent);
  moments_ = counted(Eigen::Vector3d(moments / unit_));
}

Eigen::Vector4d MiddleAxisFrame::leave(Four<double> const& q) const {
  Eigen::Vector4d out;
  out[0] = q[0];
  for (int i = 0; i < 3; ++i) out[1 + (i + first_) % 3] = q[1 + i];
  return axes_.leave(out);
}

}  // namespace actio::bodies
