// The canonical splitting of a vorticity: what the flow leaves alone, and what it stirs (Modin and Viviani,
// 2022).
//
// Of W one part commutes with P: its projection on the stabiliser of P, a function of P along the
// streamlines. Ws is that part, and Wr the rest. The energy is all in Ws, since P itself commutes with P;
// where Wr is zero, the flow is steady. In a flow that is left to itself Ws becomes the large vortices, and
// Wr the filaments.
#pragma once

#include "actio/quantized_sphere/quantized_sphere.hpp"
#include "actio/skew_matrices/dense_matrices.hpp"

namespace actio::sphere {

/// W = Ws + Wr, at right angles.
struct CanonicalSplitting {
  SkewHermitian<> steady;  ///< Ws, which commutes with P
  SkewHermitian<> rest;    ///< Wr
};

/// The splitting by given P. O(N^3) operations.
///
/// In the eigenvectors of P the projection is what is on the diagonal; eigenvalues of P that rounding cannot
/// tell apart have a block in common.
CanonicalSplitting split_along(SkewHermitian<> const& p, SkewHermitian<> const& w);
/// The splitting of a flow.
/// @param stream  the map W -> P, for instance a `SphereLaplacian`
template <class Stream>
CanonicalSplitting canonical_splitting(Stream const& stream, SkewHermitian<> const& w) {
  return split_along(stream.solve(w), w);
}

}  // namespace actio::sphere
