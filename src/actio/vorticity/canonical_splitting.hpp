// The canonical splitting of a vorticity: what the flow leaves alone, and what it stirs (Modin and Viviani,
// 2022).
//
// Of W one part commutes with P: its projection on the stabiliser of P, a function of P along the
// streamlines. Ws is that part, and Wr the rest. The energy is all in Ws, since P itself commutes with P;
// where Wr is zero, the flow is steady. In a flow that is left to itself Ws becomes the large vortices, and
// Wr the filaments.
#pragma once

#include "actio/vorticity/dense_matrices.hpp"
#include "actio/vorticity/quantized_sphere.hpp"

namespace actio {

/// W = Ws + Wr, at right angles.
struct CanonicalSplitting {
  SkewHermitian<> steady;  ///< Ws, which commutes with P
  SkewHermitian<> rest;    ///< Wr
};

/// The splitting by given P. O(N^3) operations.
///
/// In the eigenvectors of P the projection is what is on the diagonal; eigenvalues of P that rounding cannot
/// tell apart have a block in common.
inline CanonicalSplitting split_along(SkewHermitian<> const& p, SkewHermitian<> const& w) {
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
/// The splitting of a flow.
/// @param stream  the map W -> P, for instance a `SphereLaplacian`
template <class Stream>
CanonicalSplitting canonical_splitting(Stream const& stream, SkewHermitian<> const& w) {
  return split_along(stream.solve(w), w);
}

}  // namespace actio
