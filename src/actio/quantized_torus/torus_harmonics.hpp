// Fourier series of functions on the torus: as matrices, and as values on a grid.
#pragma once

#include <Eigen/Core>

#include "actio/quantized_torus/cyclic_diagonals.hpp"

namespace actio::torus {

/// The coefficients of a real function on the torus: \f$f = \sum_{m,n}f_{mn}e^{i(mx+ny)}\f$ with
/// \f$f_{-m,-n} = \bar f_{mn}\f$, |m|, |n| <= (N - 1)/2.
class TorusHarmonics {
 public:
  TorusHarmonics() = default;
  /// Zero.
  /// @throws OutsideDomain  where n is even or below 3
  explicit TorusHarmonics(int n) : coefficient(Eigen::MatrixXcd::Zero((QuantizedTorus(n).n + 1) / 2, n)) {}

  int size() const { return static_cast<int>(coefficient.cols()); }         ///< N
  int largest() const { return static_cast<int>(coefficient.rows()) - 1; }  ///< (N - 1)/2
  /// \f$f_{mn}\f$.
  std::complex<double> operator()(int m, int n) const {
    return n < 0 ? std::conj(coefficient(-n, place(-m))) : coefficient(n, place(m));
  }
  /// Sets \f$f_{mn}\f$ and its conjugate at -m, -n; of the constant the real part.
  void set(int m, int n, std::complex<double> value) {
    if (n < 0) m = -m, n = -n, value = std::conj(value);
    if (m == 0 && n == 0) value = value.real();
    coefficient(n, place(m)) = value;
    if (n == 0) coefficient(0, place(-m)) = std::conj(value);
  }

  /// (n, m), n >= 0, m modulo N.
  Eigen::MatrixXcd coefficient;

 private:
  int place(int m) const { return m < 0 ? m + size() : m; }
};

/// \f$W = i\sum f_{mn}T_{mn}\f$. O(N^2 log N) operations.
///
/// \snippet torus.cpp torus_matrix
sphere::SkewHermitian<> matrix_of(TorusHarmonics const& f);
/// The coefficients of -iW.
TorusHarmonics harmonics_of(sphere::SkewHermitian<> const& w);

/// Values on a regular grid of M by M points: (k, j) at x = 2 pi j/M, y = 2 pi k/M.
using GridValues = Eigen::MatrixXd;
/// Those of a function.
/// @param points  M in one direction, N or more
/// @throws OutsideDomain  where M < N
GridValues values_on_grid(TorusHarmonics const& f, int points);
/// The function with the wave numbers up to (N - 1)/2 whose coefficients those of the values are: on N points
/// that through all of them.
/// @param values  on M by M points
/// @throws OutsideDomain  where M < N, or N is even or below 3
TorusHarmonics harmonics_from_grid(GridValues const& values, int n);

}  // namespace actio::torus
