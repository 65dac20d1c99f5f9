#include <Eigen/Core>

#include "actio/vorticity/canonical_splitting.hpp"

namespace actio::sphere {

CanonicalSplitting split_along(SkewHermitian<> const& p, SkewHermitian<> const& w) {
  auto const n = w.size();
  auto const [values, e] = hermitian_eigensystem(p.hermitian());
  ComplexMatrix<> const adjoint = e.adjoint();
  ComplexMatrix<> part = product_of(product_of(adjoint, w.hermitian()), e);
  double const same = 16 * static_cast<double>(n) * std::numeric_limits<double>::epsilon() *
                      std::max(std::abs(values[0]), std::abs(values[n - 1]));
  Eigen::VectorXi block(n);
  for (Eigen::Index k = 0; k < n; ++k)
    block[k] = k == 0 ? 0 : block[k - 1] + (values[k] - values[k - 1] > same ? 1 : 0);
  for (Eigen::Index c = 0; c < n; ++c)
    for (Eigen::Index r = 0; r < n; ++r)
      if (block[r] != block[c]) part(r, c) = 0;
  CanonicalSplitting splitting;
  splitting.steady =
      SkewHermitian<>(ComplexMatrix<>(std::complex<double>(0, 1) * product_of(product_of(e, part), adjoint)));
  splitting.rest = w - splitting.steady;
  return splitting;
}

}  // namespace actio::sphere
