#include "actio/quantized_torus/torus_harmonics.hpp"

#include "actio/quantized_torus/fft.hpp"

namespace actio::torus {
namespace {

/// \f$e^{i\pi mn/N}\f$, m = 0 .. N - 1 standing for the numbers from -(N - 1)/2 to (N - 1)/2.
std::complex<double> half_way(int size, int m, int n) {
  long const centred = m > (size - 1) / 2 ? m - size : m;
  return std::polar(1.0, M_PI * static_cast<double>(centred * n % (2L * size)) / size);
}
void require_points(int points, int n) {
  if (points < n)
    throw OutsideDomain("torus", "a grid must have at least N points in each direction", points, n);
}
/// Memory for the coefficients of values on M by M points.
class Half {
 public:
  explicit Half(int points)
      : columns_(points / 2 + 1),
        memory_(detail::fft_allocate(static_cast<std::size_t>(points) * static_cast<std::size_t>(columns_)),
                detail::fft_free) {}
  std::complex<double>* data() { return memory_.get(); }
  std::complex<double>& at(int m, int n) { return memory_.get()[static_cast<long>(m) * columns_ + n]; }

 private:
  int columns_;
  std::unique_ptr<std::complex<double>, void (*)(void*)> memory_;
};

}  // namespace

sphere::SkewHermitian<> matrix_of(TorusHarmonics const& f) {
  int const size = f.size();
  CyclicDiagonals::Block block(size);
  for (int m = 0; m < size; ++m)
    for (int n = 0; n <= f.largest(); ++n) block.rows()(n, m) = f.coefficient(n, m) * half_way(size, m, n);
  CyclicDiagonals const diagonals{QuantizedTorus(size)};
  sphere::SkewHermitian<> w(size);
  diagonals.backwards(block), diagonals.put(block, w);
  return w;
}

TorusHarmonics harmonics_of(sphere::SkewHermitian<> const& w) {
  int const size = static_cast<int>(w.size());
  TorusHarmonics f(size);
  CyclicDiagonals const diagonals{QuantizedTorus(size)};
  CyclicDiagonals::Block block(size);
  diagonals.take(w, block), diagonals.forwards(block);
  for (int m = 0; m < size; ++m)
    for (int n = 0; n <= f.largest(); ++n)
      f.coefficient(n, m) = block.rows()(n, m) * std::conj(half_way(size, m, n)) / static_cast<double>(size);
  return f;
}

GridValues values_on_grid(TorusHarmonics const& f, int points) {
  int const most = f.largest();
  require_points(points, f.size());
  Half half(points);
  std::fill(half.data(), half.data() + static_cast<long>(points) * (points / 2 + 1), 0);
  for (int m = -most; m <= most; ++m)
    for (int n = 0; n <= most; ++n) half.at(m < 0 ? m + points : m, n) = f(m, n);
  GridValues values(points, points);
  detail::fft_to_values(points, half.data(), values.data());
  return values;
}

TorusHarmonics harmonics_from_grid(GridValues const& values, int n) {
  int const points = static_cast<int>(values.rows());
  require_points(points, n);
  require_points(static_cast<int>(values.cols()), points);
  TorusHarmonics f(n);
  Half half(points);
  detail::fft_from_values(points, values.data(), half.data());
  double const all = static_cast<double>(points) * points;
  for (int m = -f.largest(); m <= f.largest(); ++m)
    for (int k = 0; k <= f.largest(); ++k)
      if (k > 0 || m >= 0) f.set(m, k, half.at(m < 0 ? m + points : m, k) / all);
  return f;
}

}  // namespace actio::torus
