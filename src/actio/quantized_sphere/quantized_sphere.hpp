// The quantised sphere: matrices in the place of functions (Hoppe; thesis, chapter 10).
//
// The coordinates x_1, x_2, x_3 of the unit sphere become the Hermitian matrices hbar S_j, S_j being the spin
// matrices of size N, [S_1, S_2] = i S_3, and hbar = 2/sqrt(N^2 - 1), so that the sum of their squares is 1.
// Functions become Hermitian matrices, and their Poisson bracket {f, g} = x . (grad f x grad g) the
// commutator [f, g]/(i hbar), up to terms of relative size 1/N^2 at fixed degrees. A vorticity omega is
// stored as the skew-Hermitian W = i omega, in the Lie algebra of U(N).
#pragma once

#include <cmath>

#include "actio/numbers/errors.hpp"
#include "actio/skew_matrices/skew_hermitian.hpp"

namespace actio::sphere {

/// The sphere as matrices of size N.
struct QuantizedSphere {
  int n;  ///< N, at least 2; functions have the degrees 0 .. N - 1
  /// Rotations commute with the flow, and an angular momentum is conserved.
  static constexpr bool turns = true;

  /// @throws OutsideDomain  where N < 2
  explicit QuantizedSphere(int size) : n(size) {
    if (size < 2) throw OutsideDomain("quantised sphere", "N must be at least 2; it is", size, 2);
  }

  /// \f$\hbar = 2/\sqrt{N^2-1}\f$.
  double hbar() const { return 2 / std::sqrt((n - 1.0) * (n + 1.0)); }
  /// The entry (k, k) of \f$S_3\f$: \f$(N-1)/2 - k\f$.
  double weight(int k) const { return 0.5 * (n - 1) - k; }
  /// The entry (k, k + 1) of \f$S_1\f$, \f$\tfrac12\sqrt{(k+1)(N-1-k)}\f$; that of \f$S_2\f$ is -i times as
  /// much.
  double ladder(int k) const { return 0.5 * std::sqrt((k + 1.0) * (n - 1.0 - k)); }
  /// \f$|S_j|^2 = \mathrm{Tr}S_j^2 = N(N^2-1)/12\f$.
  double spin_square() const { return n * (n - 1.0) * (n + 1.0) / 12; }
  /// What a sum over the matrix has to be multiplied by to be an integral over the sphere: \f$4\pi/N\f$.
  double area_element() const { return 4 * M_PI / n; }

  /// \f$S_j\f$ as a Hermitian matrix.
  /// @param axis  j - 1: 0, 1 or 2
  ComplexMatrix<> spin(int axis) const;
};

}  // namespace actio::sphere
