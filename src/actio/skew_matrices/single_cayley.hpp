// The Cayley transform of A in single precision, by products alone.
//
// With X = -A^2, which is Hermitian with eigenvalues in [0, |A|^2], and S = 1/(1 + X) as a polynomial in X,
//
//   (1 - A)^{-1} = 1 + K,   K = (S - 1) + A S,   cay(A) = (1 - A)^{-1}(1 + A) = 1 + 2K.
//
// Of both terms of K, Hermitian and skew-Hermitian, half is computed. Conjugations follow from
// F = K X + X K^* and E = K X K^*:
//
//   (1 + K) X (1 + K)^* = X + F + E,   cay(A) X cay(A)^* = X + 2F + 4E.
//
// Single precision is enough where what is conjugated is small beside what the result is added to.
#pragma once

#include <Eigen/Core>

#include "actio/skew_matrices/products.hpp"

namespace actio::sphere {

/// \f$K = (1-A)^{-1} - 1\f$ and conjugations by it.
class SingleCayley {
 public:
  using Part = Eigen::MatrixXf;  ///< real matrices

  /// With memory that is taken when the size is known.
  explicit SingleCayley(Products products = eigen_products()) : products_(std::move(products)) {}

  /// K of a skew-Hermitian matrix.
  /// @param radius  a bound of its eigenvalues
  /// @param error   of S, if it is not below the rounding of single precision: lower degrees are cheaper
  void factor(SkewHermitian<> const& a, double radius, double error = 2e-9);

  /// F and E of a skew-Hermitian X, on and below their diagonals; both are skew-Hermitian.
  /// @param reach  beyond it X may be taken for zero
  void conjugate(SkewHermitian<float> const& x, SkewHermitian<float>& f, SkewHermitian<float>& e,
                 Eigen::Index reach = Reach::everything) {
    both_sides(k_, x, reach, star_, f, e);
  }
  /// \f$[A, X]\f$ and \f$AXA\f$ of a skew-Hermitian X, on and below their diagonals, with the A of which K
  /// is.
  /// @param factor  A is rounded to single precision times this number, and the results are divided by it:
  ///                where it is no power of two, the roundings are others than those of K
  /// @param reach   beyond it X may be taken for zero
  void evaluate(SkewHermitian<> const& a, double factor, SkewHermitian<float> const& x,
                SkewHermitian<float>& f, SkewHermitian<float>& e, Eigen::Index reach = Reach::everything);

  /// \f$[Y, X]\f$ of skew-Hermitian matrices, on and below its diagonal, in single precision.
  void commutator(SkewHermitian<float> const& y, SkewHermitian<float> const& x, SkewHermitian<float>& c);

  /// The degree of the polynomial in X for a given radius of A, even.
  static int degree(double radius, double error = 2e-9);

 private:
  /// A complex matrix for products by three real ones.
  struct Split {
    Part real, imaginary, sum;
    Eigen::Index reach = Reach::everything;  ///< beyond it is nothing but rounding
  };
  void allocate(Eigen::Index n);
  void fit(SkewHermitian<float>& m) const {
    if (m.size() != t1_.rows()) m = SkewHermitian<float>(t1_.rows());
  }
  /// Calls `use(below)` for each column; below(m) is what m has in it from the diagonal on.
  template <class Use>
  void over_columns(Use const& use) {
    Eigen::Index const n = t1_.rows();
    for (Eigen::Index j = 0; j < n; ++j) use([j, n](Part& m) { return m.col(j).tail(n - j).array(); });
  }
  /// A Hermitian matrix of which the lower half is known.
  static void complete(Split& m);
  /// What m has above the diagonal, from what its adjoint has below.
  static void adjoin(Split& m, Split const& star, Eigen::Index i, Eigen::Index j, Eigen::Index rows,
                     Eigen::Index columns);
  /// \f$G - G^*\f$, on and below the diagonal.
  void skew_part(SkewHermitian<float>& out) const;

  /// The lower half of a product, as three real ones.
  void lower(Split const& a, Split const& b);
  /// With G = L X: F = G - G^* and E = G R, on and below their diagonals.
  void both_sides(Split const& left, SkewHermitian<float> const& x, Eigen::Index reach_of_x,
                  Split const& right, SkewHermitian<float>& f, SkewHermitian<float>& e);
  /// The coefficients of the polynomial p in x that is 1/(1 + x) - 1 where Chebyshev's polynomial T of [0, b]
  /// vanishes: 1 + p = (1 - T/T(-1))/(1 + x).
  static Eigen::VectorXd reciprocal(double b, double error);

  Products products_;
  Split a_;          ///< A
  Split x_, y_, h_;  ///< X, X^2, S - 1
  Split k_, star_;   ///< K and its adjoint
  Split g_;
  Part t1_, t2_, t3_;
};

}  // namespace actio::sphere
