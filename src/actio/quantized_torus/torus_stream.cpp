#include "actio/quantized_torus/torus_stream.hpp"

namespace actio::torus {

TorusStream::TorusStream(int n, double gamma)
    : torus_(n), gamma_(gamma), diagonals_(torus_), factor_((n + 1) / 2, n) {
  if (!std::isfinite(gamma)) throw NotFinite("torus: gamma");
  if (!(gamma >= 0)) throw OutsideDomain("torus", "gamma must be at least 0", gamma, 0);
  for (int m = 0; m < n; ++m)
    for (int k = 0; k < factor_.rows(); ++k)
      factor_(k, m) = k == 0 && m == 0 ? 0 : 1 / (n * (torus_.eigenvalue(m, k) - gamma));
}

void TorusStream::solve(sphere::SkewHermitian<> const& w, sphere::SkewHermitian<>& p) const {
  CyclicDiagonals::Block block(torus_.n);
  diagonals_.take(w, block), diagonals_.forwards(block);
  // [torus_stream]
  block.rows().array() *= factor_.array();
  // [torus_stream]
  diagonals_.backwards(block), diagonals_.put(block, p);
}

sphere::SkewHermitian<> TorusStream::apply(sphere::SkewHermitian<> const& w) const {
  CyclicDiagonals::Block block(torus_.n);
  diagonals_.take(w, block), diagonals_.forwards(block);
  auto& rows = block.rows();
  rows(0, 0) = 0;
  double const square = static_cast<double>(torus_.n) * torus_.n;
  for (Eigen::Index i = 1; i < rows.size(); ++i) rows.data()[i] /= square * factor_.data()[i];
  sphere::SkewHermitian<> out(torus_.n);
  diagonals_.backwards(block), diagonals_.put(block, out);
  return out;
}

}  // namespace actio::torus
