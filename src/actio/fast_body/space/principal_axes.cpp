#include "actio/fast_body/space/principal_axes.hpp"

namespace actio::bodies {

PrincipalAxes::PrincipalAxes(Eigen::Matrix3d const& axes) : turned_(!is_identity(axes)) {
  if (!turned_) return;
  if (!is_finite(axes)) throw NotFinite("principal axes");
  double const off = magnitude((axes.transpose() * axes - Eigen::Matrix3d::Identity()).eval());
  if (!(off <= 1e-9))
    throw OutsideDomain("principal axes",
                        "unit vectors at right angles are needed; largest entry of A^T A - 1", off, 1e-9);
  double const volume = axes.determinant();
  if (!(volume > 0))
    throw OutsideDomain("principal axes", "a rotation is needed, not a reflection; the determinant", volume,
                        1);
  axes_ = axes;
  turn_ = quaternion_of_rotation<double>(axes);
}

}  // namespace actio::bodies
