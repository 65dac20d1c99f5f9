#include "actio/skew_matrices/bracket_blocks.hpp"

namespace actio::sphere {

int symmetry_of(SkewHermitian<> const& w, double bound) {
  auto const n = static_cast<int>(w.size());
  double const zero = bound * std::max(w.real.cwiseAbs().maxCoeff(), w.imaginary.cwiseAbs().maxCoeff());
  int fold = 0;
  for (int m = 1; m < n && fold != 1; ++m) {
    double const largest =
        std::max(w.real.diagonal(-m).cwiseAbs().maxCoeff(), w.imaginary.diagonal(-m).cwiseAbs().maxCoeff());
    // What is no number is not zero.
    if (!(largest <= zero)) fold = std::gcd(fold, m);
  }
  return fold;
}

SkewHermitian<> symmetric_part(SkewHermitian<> w, int fold) {
  auto const n = static_cast<int>(w.size());
  for (int c = 0; c < n; ++c)
    for (int r = 0; r < n; ++r)
      if ((r - c) % fold != 0) w.real(r, c) = w.imaginary(r, c) = 0;
  return w;
}

}  // namespace actio::sphere
