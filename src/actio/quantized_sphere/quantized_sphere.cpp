#include "actio/quantized_sphere/quantized_sphere.hpp"

namespace actio::sphere {

ComplexMatrix<> QuantizedSphere::spin(int axis) const {
  ComplexMatrix<> s = ComplexMatrix<>::Zero(n, n);
  std::complex<double> const above = axis == 0 ? 1 : std::complex<double>(0, -1);
  for (int k = 0; k < n; ++k) {
    if (axis == 2) s(k, k) = weight(k);
    if (axis != 2 && k + 1 < n) s(k, k + 1) = ladder(k) * above, s(k + 1, k) = std::conj(s(k, k + 1));
  }
  return s;
}

}  // namespace actio::sphere
