#include <Eigen/Core>

#include "actio/quantized_sphere/spin_commutator.hpp"

namespace actio::sphere {

SkewHermitian<> spin_commutator(QuantizedSphere const& sphere, int axis, SkewHermitian<> const& w) {
  int const n = sphere.n;
  SkewHermitian<> out(n);
  if (axis == 2) {
    // i (s_r - s_c) (R + iJ), and s_r - s_c = c - r.
    for (int c = 0; c < n; ++c)
      for (int r = 0; r < n; ++r)
        out.real(r, c) = (r - c) * w.imaginary(r, c), out.imaginary(r, c) = (c - r) * w.real(r, c);
    return out;
  }
  // S_1 = K + K^T, and i S_2 = K - K^T, with K above the diagonal.
  double const sign = axis == 0 ? 1 : -1;
  auto const products = [&](auto const& m, auto&& into) {
    for (int c = 0; c < n; ++c)
      for (int r = 0; r < n; ++r) {
        double sum = 0;
        if (r + 1 < n) sum += sphere.ladder(r) * m(r + 1, c);
        if (r > 0) sum += sign * sphere.ladder(r - 1) * m(r - 1, c);
        if (c > 0) sum -= sphere.ladder(c - 1) * m(r, c - 1);
        if (c + 1 < n) sum -= sign * sphere.ladder(c) * m(r, c + 1);
        into(r, c, sum);
      }
  };
  if (axis == 0) {
    products(w.real, [&](int r, int c, double x) { out.imaginary(r, c) = x; });
    products(w.imaginary, [&](int r, int c, double x) { out.real(r, c) = -x; });
  } else {
    products(w.real, [&](int r, int c, double x) { out.real(r, c) = x; });
    products(w.imaginary, [&](int r, int c, double x) { out.imaginary(r, c) = x; });
  }
  return out;
}

double spin_component(QuantizedSphere const& sphere, int axis, SkewHermitian<> const& w) {
  int const n = sphere.n;
  double sum = 0;
  for (int k = 0; k < n; ++k) {
    if (axis == 2) sum += sphere.weight(k) * w.imaginary(k, k);
    // S_1 has the entries of the ladder on both sides; -iW = J - iR.
    if (axis == 0 && k + 1 < n) sum += 2 * sphere.ladder(k) * w.imaginary(k + 1, k);
    if (axis == 1 && k + 1 < n) sum -= 2 * sphere.ladder(k) * w.real(k + 1, k);
  }
  return sum;
}

void add_spin(QuantizedSphere const& sphere, Eigen::Vector3d const& e, SkewHermitian<>& w) {
  for (int k = 0; k < sphere.n; ++k) {
    w.imaginary(k, k) += e[2] * sphere.weight(k);
    if (k + 1 == sphere.n) break;
    double const r = e[1] * sphere.ladder(k), j = e[0] * sphere.ladder(k);
    w.real(k, k + 1) += r, w.real(k + 1, k) -= r;
    w.imaginary(k, k + 1) += j, w.imaginary(k + 1, k) += j;
  }
}

}  // namespace actio::sphere
