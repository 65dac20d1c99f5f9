#include "actio/rigid_body/principal_inertia.hpp"

namespace actio {

PrincipalInertia principal_inertia(Eigen::Matrix3d const& tensor) {
  if (!is_finite(tensor)) throw NotFinite("inertia: tensor");
  double const scale = magnitude(tensor);
  double const skew = scale > 0 ? magnitude((tensor - tensor.transpose()).eval()) / scale : 0.0;
  if (skew > inertia_tolerance<double>())
    throw OutsideDomain("inertia",
                        "a tensor of inertia is symmetric; largest difference across the "
                        "diagonal, in units of the largest entry",
                        skew, inertia_tolerance<double>());
  if (scale == 0) return {inertia_from_moments(0, 0, 0), tensor};  // refused there
  SymmetricEigen const found = symmetric_eigen(tensor / scale);
  Eigen::Matrix3d axes = found.vectors;
  if (axes.determinant() < 0) axes.col(0) = -axes.col(0);
  return {inertia_from_moments<double>(found.values * scale), axes};
}

}  // namespace actio
