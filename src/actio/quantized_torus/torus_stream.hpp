// The stream function of a flow on the torus: (Delta - gamma) P = W.
//
// With clock and shift Delta W = -(N/2 pi)^2 ([C, [C^*, W]] + [S, [S^*, W]]), whose eigenvectors are the
// T_mn. It takes each cyclic diagonal to itself, and there it is a convolution: P takes one Fourier transform
// of each diagonal and one back, O(N^2 log N) operations in all.
//
// gamma = 0 is Euler's fluid. With gamma > 0, the square of the inverse of the radius of deformation, it is
// the equation of Charney, Hasegawa and Mima: of a layer whose depth may change, or of the drift waves of a
// plasma.
#pragma once

#include "actio/quantized_torus/cyclic_diagonals.hpp"

namespace actio::torus {

/// \f$(\Delta-\gamma)^{-1}\f$ on the matrices with trace zero, \f$\gamma\ge0\f$.
///
/// \snippet torus.cpp torus_stream
class TorusStream {
 public:
  using Surface = QuantizedTorus;  ///< of which the matrices are the functions

  /// N(N + 1)/2 numbers are stored.
  /// @param gamma  what is subtracted from the Laplacian
  /// @throws OutsideDomain  where N is even or below 3, or gamma below 0
  /// @throws NotFinite      where gamma is no number
  explicit TorusStream(int n, double gamma = 0);
  int size() const { return torus_.n; }    ///< N
  double gamma() const { return gamma_; }  ///< what is subtracted from the Laplacian

  /// \f$(\Delta-\gamma)W\f$, but for its trace, which is zero. O(N^2 log N) operations.
  sphere::SkewHermitian<> apply(sphere::SkewHermitian<> const& w) const;
  /// The P with trace zero of \f$(\Delta-\gamma)P = W - \mathrm{Tr}(W)/N\f$. O(N^2 log N) operations.
  ///
  /// Accuracy: relative to |P| a few roundings.
  void solve(sphere::SkewHermitian<> const& w, sphere::SkewHermitian<>& p) const;
  /// The same as a value.
  sphere::SkewHermitian<> solve(sphere::SkewHermitian<> const& w) const {
    sphere::SkewHermitian<> p(torus_.n);
    solve(w, p);
    return p;
  }

 private:
  QuantizedTorus torus_;
  double gamma_;
  CyclicDiagonals diagonals_;
  Eigen::MatrixXd factor_;  ///< (n, m): 1/N over the eigenvalue
};

}  // namespace actio::torus
