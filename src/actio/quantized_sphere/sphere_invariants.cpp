#include <Eigen/Core>

#include "actio/quantized_sphere/sphere_invariants.hpp"

namespace actio::sphere {

Eigen::VectorXd vorticity_casimirs(SkewHermitian<> const& w, int most) {
  double const area = QuantizedSphere(static_cast<int>(w.size())).area_element();
  ComplexMatrix<> const x = w.hermitian();
  ComplexMatrix<> low = x, high = x;  // x^j, and x^j or x^(j+1)
  Eigen::VectorXd casimirs(std::max(0, most - 1));
  for (int k = 2; k <= most; ++k) {
    // Tr(A B) of Hermitian matrices.
    casimirs[k - 2] = area * (low.conjugate().cwiseProduct(high)).sum().real();
    if (k == most) break;
    if (k % 2 == 0) {
      high = product_of(high, x);
    } else {
      low = high;
    }
  }
  return casimirs;
}

}  // namespace actio::sphere
