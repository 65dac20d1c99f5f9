// Matrices as functions on the sphere: two symbols.
//
// Weyl's symbol has the coefficients of the matrix. Berezin's is the mean of the matrix in the coherent state
// at each place, f(x) = <x|(-iW)|x>: its coefficients are those of the matrix times
//
//   b_l = prod_{k <= l} sqrt((N - k)/(N + k)),
//
// about exp(-l(l + 1)/(2N)), so that it is smooth below the distance 1/sqrt(N), and its values, being means,
// never leave the interval of the eigenvalues of -iW, whatever the flow has made of it. Those of Weyl's
// symbol do.
#pragma once

#include <Eigen/Core>

#include "actio/quantized_sphere/matrix_harmonics.hpp"

namespace actio::sphere {

/// How a matrix becomes a function.
enum class Symbol {
  weyl,    ///< with its own coefficients
  berezin  ///< with values between its least and its greatest eigenvalue
};

/// What each degree is multiplied by, l = 0 .. N - 1.
Eigen::ArrayXd symbol_factors(int n, Symbol symbol);

/// The coefficients of the symbol, from those of the matrix.
inline SphereHarmonics symbol_of(SphereHarmonics f, Symbol symbol) {
  f.coefficient.array().colwise() *= symbol_factors(f.degrees(), symbol).cast<std::complex<double>>();
  return f;
}
/// The coefficients of the symbol of \f$-iW\f$.
inline SphereHarmonics symbol_of(SkewHermitian<> const& w, Symbol symbol) {
  return symbol_of(harmonics_of(w), symbol);
}

}  // namespace actio::sphere
