// The cyclic diagonals of a skew-Hermitian matrix, and their Fourier transforms.
//
// The cyclic diagonal n of -iW, with the entries (k, k + n mod N), is the part of the function that goes as
// exp(iny), at the N places x = 2 pi (k + n/2)/N:
//
//   -i W(k, k + n) = sum_m f_mn exp(2 pi i m (k + n/2)/N).
//
// That of -n is the conjugate of it, and N is odd: the diagonals n = 0 .. (N - 1)/2 hold all of the matrix,
// each entry of it once but for those of the main one.
#pragma once

#include <Eigen/Core>

#include <memory>

#include "actio/quantized_torus/quantized_torus.hpp"

namespace actio::torus {

/// Takes cyclic diagonals out of matrices of one size and puts them back, and transforms them.
///
/// What transforms them is FFTW, with plans that depend on the size alone: results are the same from run to
/// run, bit for bit.
class CyclicDiagonals {
 public:
  /// (n, k): the diagonal n in the row n
  using Rows = Eigen::Map<Eigen::MatrixXcd, Eigen::Aligned16>;
  /// Memory for the diagonals of one matrix.
  class Block {
   public:
    /// For matrices of the size N.
    explicit Block(int size);
    Rows& rows() { return rows_; }  ///< (N + 1)/2 rows of N numbers

   private:
    std::unique_ptr<std::complex<double>, void (*)(void*)> memory_;
    Rows rows_;
  };

  /// Of matrices of the size n.
  explicit CyclicDiagonals(QuantizedTorus const& torus);
  int size() const { return n_; }  ///< N

  /// -iW(k, k + n).
  void take(sphere::SkewHermitian<> const& w, Block& block) const;
  /// The matrix of which they are; what of its main diagonal is not real is left out.
  void put(Block& block, sphere::SkewHermitian<>& w) const;

  /// \f$\sum_k g_{nk}e^{-2\pi imk/N}\f$ at (n, m), m = 0 .. N - 1.
  void forwards(Block& block) const;
  /// \f$\sum_m g_{nm}e^{2\pi imk/N}\f$ at (n, k).
  void backwards(Block& block) const;

 private:
  using Plan = std::shared_ptr<void>;

  int n_;
  Plan forwards_, backwards_;
};

}  // namespace actio::torus
