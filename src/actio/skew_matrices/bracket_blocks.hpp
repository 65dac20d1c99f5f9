// Flows that look the same after a turn by 1/k of the circle, at 1/k^2 of the operations.
//
// Harmonics of the orders that are multiples of k make matrices whose diagonals are such multiples; with the
// rows and columns sorted by their number modulo k these are k blocks of size N/k, and so are P, A and all
// products. A step keeps the symmetry, so it may be made on the blocks alone: nothing is multiplied that is
// zero.
#pragma once

#include <Eigen/Core>

#include <numeric>

#include "actio/skew_matrices/products.hpp"

namespace actio::sphere {

/// The largest k for which W is that of a k-fold symmetric flow about the pole: the greatest common divisor
/// of its diagonals that are not zero.
/// @param bound  entries up to this multiple of the largest one count as zero
/// @return       0 for a zonal flow, that any turn leaves as it is
int symmetry_of(SkewHermitian<> const& w, double bound = 0);

/// What is not on the diagonals that are multiples of k becomes zero: the part that a turn by 1/k leaves as
/// it is.
SkewHermitian<> symmetric_part(SkewHermitian<> w, int fold);

/// Products of k-fold symmetric matrices, block by block, each block by other products.
///
/// What the matrices have outside the blocks is not looked at.
class SymmetricProducts : public ProductsBy<SymmetricProducts> {
 public:
  /// @param fold  k, at least 1
  explicit SymmetricProducts(int fold, Products products = eigen_products())
      : fold_(std::max(1, fold)), products_(std::move(products)) {}

  /// out = a b.
  template <class Part>
  void whole(Part const& a, Part const& b, Part& out, Reach reach = {}) const {
    Reach const of_block{reach.left / fold_, reach.right / fold_};
    over_blocks(a, b, out,
                [&](Part const& x, Part const& y, Part& z) { products_->multiply(x, y, z, of_block); });
  }
  /// out = a b, on and below the diagonal.
  template <class Part>
  void lower(Part const& a, Part const& b, Part& out, Reach reach = {}) const {
    Reach const of_block{reach.left / fold_, reach.right / fold_};
    over_blocks(a, b, out,
                [&](Part const& x, Part const& y, Part& z) { products_->multiply_lower(x, y, z, of_block); });
  }

 private:
  template <class Part, class Multiply>
  void over_blocks(Part const& a, Part const& b, Part& out, Multiply const& multiply) const {
    using Stride = Eigen::Stride<Eigen::Dynamic, Eigen::Dynamic>;
    Eigen::Index const n = a.rows();
    out.setZero(n, n);
    Part x, y, z;
    for (Eigen::Index first = 0; first < std::min<Eigen::Index>(fold_, n); ++first) {
      // The rows and columns first, first + k, first + 2k, ..., in their order.
      Eigen::Index const count = (n - first + fold_ - 1) / fold_, at = first * (n + 1);
      Stride const stride(fold_ * n, fold_);
      x = Eigen::Map<Part const, 0, Stride>(a.data() + at, count, count, stride);
      y = Eigen::Map<Part const, 0, Stride>(b.data() + at, count, count, stride);
      z.setZero(count, count);
      multiply(x, y, z);
      Eigen::Map<Part, 0, Stride>(out.data() + at, count, count, stride) = z;
    }
  }
  Eigen::Index fold_;
  Products products_;
};

}  // namespace actio::sphere
