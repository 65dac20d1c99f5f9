// Commutators with a matrix that has a few diagonals: no product of matrices is needed.
#pragma once

#include <Eigen/Core>

#include <algorithm>

#include "actio/skew_matrices/skew_hermitian.hpp"

namespace actio::sphere {

/// A skew-Hermitian matrix that is zero but for a few diagonals: \f$Y_{c+d,c}\f$ at (d, c), d = 0, 1, ...;
/// zero where the matrix ends.
template <class Real>
struct SkewBand {
  using Diagonals = Eigen::Array<Real, Eigen::Dynamic, Eigen::Dynamic>;  ///< a row for each
  Diagonals real;                                                        ///< of the real part
  Diagonals imaginary;                                                   ///< of the imaginary part
};
/// The Frobenius norm of the matrix.
template <class Real>
Real norm(SkewBand<Real> const& y) {
  Real const own = y.imaginary.row(0).square().sum() + y.real.row(0).square().sum();
  return std::sqrt(2 * (y.real.square().sum() + y.imaginary.square().sum()) - own);
}

/// \f$[Y, X]\f$ of a skew-Hermitian X, on and below its diagonal; \f$O(N^2)\f$ operations for each diagonal.
template <class Real>
void banded_commutator(SkewBand<Real> const& y, SkewHermitian<Real> const& x, SkewHermitian<Real>& out) {
  auto const n = x.size(), most = y.real.rows() - 1;
  if (out.size() != n) out = SkewHermitian<Real>(n);
  // Of the rows i those with their entries at i + d, in a row of memory; above its diagonal Y has -Y^*.
  using Rows = Eigen::Array<Real, Eigen::Dynamic, Eigen::Dynamic>;
  Rows real(n, 2 * most + 1), imaginary(n, 2 * most + 1);
  for (Eigen::Index d = 0; d <= most; ++d) {
    real.col(most - d).tail(n - d) = y.real.row(d).head(n - d).transpose();
    imaginary.col(most - d).tail(n - d) = y.imaginary.row(d).head(n - d).transpose();
    real.col(most + d).head(n - d) = (d == 0 ? 1 : -1) * y.real.row(d).head(n - d).transpose();
    imaginary.col(most + d).head(n - d) = y.imaginary.row(d).head(n - d).transpose();
  }
  for (Eigen::Index c = 0; c < n; ++c) {
    auto re = out.real.col(c).array(), im = out.imaginary.col(c).array();
    re.tail(n - c).setZero(), im.tail(n - c).setZero();
    for (Eigen::Index d = -most; d <= most; ++d) {
      // Y X: rows of Y with their entries on the diagonal d.
      auto const begin = std::max(c, -d), count = std::min(n, n - d) - begin;
      if (count > 0) {
        auto const yr = real.col(most + d).segment(begin, count),
                   yi = imaginary.col(most + d).segment(begin, count);
        auto const xr = x.real.col(c).segment(begin + d, count).array(),
                   xi = x.imaginary.col(c).segment(begin + d, count).array();
        re.segment(begin, count) += yr * xr - yi * xi;
        im.segment(begin, count) += yr * xi + yi * xr;
      }
      // X Y: the column c + d of X, and the entry of Y in that row and the column c.
      if (c + d < 0 || c + d >= n) continue;
      Real const yr = real(c + d, most - d), yi = imaginary(c + d, most - d);
      auto const xr = x.real.col(c + d).tail(n - c).array(), xi = x.imaginary.col(c + d).tail(n - c).array();
      re.tail(n - c) -= yr * xr - yi * xi;
      im.tail(n - c) -= yr * xi + yi * xr;
    }
  }
}

}  // namespace actio::sphere
