#include "actio/quantized_torus/quantized_torus.hpp"

namespace actio::torus {

sphere::ComplexMatrix<> QuantizedTorus::wave(int along_x, int along_y) const {
  sphere::ComplexMatrix<> t = sphere::ComplexMatrix<>::Zero(n, n);
  for (int k = 0; k < n; ++k) {
    // The phase as a fraction of a turn, of which whole turns are left out before it is rounded.
    long const halves = static_cast<long>(along_x) * (2L * k + along_y) % (2L * n);
    t(k, ((k + along_y) % n + n) % n) = std::polar(1.0, M_PI * static_cast<double>(halves) / n);
  }
  return t;
}

}  // namespace actio::torus
