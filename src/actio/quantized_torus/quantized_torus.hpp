// The quantised flat torus: matrices in the place of functions of two angles (Zeitlin; thesis, chapter 10).
//
// Clock and shift, C = diag(q^k) and (S f)_k = f_{k+1}, q = exp(2 pi i/N), take the places of exp(ix) and
// exp(iy): S C = q C S. The function exp(i(mx + ny)) becomes
//
//   T_mn = q^(mn/2) C^m S^n,   |m|, |n| <= (N - 1)/2,   T_mn^* = T_{-m,-n},
//
// unitary, and a commutator is the sine bracket
//
//   [T_a, T_b] = 2i sin(pi (a_2 b_1 - a_1 b_2)/N) T_{a+b},
//
// where {exp(ia.x), exp(ib.x)} = (a_2 b_1 - a_1 b_2) exp(i(a + b).x): with hbar = 2 pi/N the bracket of
// functions is [f, g]/(i hbar), up to terms of relative size (pi (a x b)/N)^2/6. A sum a + b beyond the range
// comes in again at the other side, with the sign that q^(mn/2) has there.
//
// N is odd. For an even N the wave number N/2 would be its own negative, a mode (the checkerboard) without a
// partner.
#pragma once

#include <cmath>

#include "actio/numbers/errors.hpp"
#include "actio/skew_matrices/skew_hermitian.hpp"

namespace actio::torus {

/// The torus of the lengths 2 pi as matrices of size N.
struct QuantizedTorus {
  int n;  ///< N, odd and at least 3; functions have the wave numbers up to (N - 1)/2 in both directions
  /// Rotations do not commute with the flow, and there is no angular momentum.
  static constexpr bool turns = false;

  /// @throws OutsideDomain  where N < 3, or where N is even
  explicit QuantizedTorus(int size) : n(size) {
    if (size < 3) throw OutsideDomain("quantised torus", "N must be at least 3; it is", size, 3);
    if (size % 2 == 0)
      throw OutsideDomain("quantised torus", "N must be odd, as the next number is; it is", size, size + 1);
  }

  /// \f$\hbar = 2\pi/N\f$.
  double hbar() const { return 2 * M_PI / n; }
  /// What a sum over the matrix has to be multiplied by to be an integral over the torus: \f$4\pi^2/N\f$.
  double area_element() const { return 4 * M_PI * M_PI / n; }
  /// (N - 1)/2, the largest wave number.
  int largest() const { return (n - 1) / 2; }
  /// That of the Laplacian: \f$-(N/\pi)^2(\sin^2(\pi m/N) + \sin^2(\pi n/N))\f$, about
  /// \f$-(m^2+n^2)\f$ for small wave numbers.
  double eigenvalue(int along_x, int along_y) const {
    double const a = std::sin(M_PI * along_x / n), b = std::sin(M_PI * along_y / n), s = n / M_PI;
    return -s * s * (a * a + b * b);
  }

  /// \f$T_{mn}\f$, the matrix of \f$e^{i(mx+ny)}\f$, |m|, |n| <= (N - 1)/2. `wave(1, 0)` is the clock C,
  /// `wave(0, 1)` the shift S.
  sphere::ComplexMatrix<> wave(int along_x, int along_y) const;
};

}  // namespace actio::torus
