#include "actio/rigid_body/heavy_top_body.hpp"

namespace actio {

TurnedHeavyTop held_anywhere(double mass, Eigen::Matrix3d const& tensor, Eigen::Vector3d const& centre,
                             Eigen::Vector3d const& gravity) {
  if (!is_finite(mass) || !is_finite(centre)) throw NotFinite("heavy top: mass or centre of mass");
  if (mass < 0) throw OutsideDomain("heavy top", "the mass must not be negative", mass, 0);
  principal_inertia(tensor);  // refuses what is no inertia of a body
  auto const [inertia, axes] = principal_inertia(
      tensor + mass * (centre.squaredNorm() * Eigen::Matrix3d::Identity() - centre * centre.transpose()));
  return {heavy_top<double>(mass, inertia, axes.transpose() * centre, gravity), axes};
}

}  // namespace actio
