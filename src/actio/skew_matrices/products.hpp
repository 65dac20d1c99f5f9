// Products of the matrices that a step is made of, by products of real matrices.
//
// A complex product by three real ones, (A + iB)(C + iD): AC, BD and (A + B)(C + D); and of a product that is
// known to be skew-Hermitian only the lower half. Where the factors are smooth they are nothing but rounding
// far from their diagonals, and there nothing is multiplied (Reach). Whatever multiplies real matrices can
// serve (MatrixProducts): Eigen, a BLAS, block by block, or what a reader has.
#pragma once

#include <Eigen/Core>

#include <memory>

#include "actio/skew_matrices/reach.hpp"

namespace actio::sphere {

/// What multiplies real square matrices of one size, in both precisions.
class MatrixProducts {
 public:
  using Double = Eigen::MatrixXd;  ///< in double precision
  using Single = Eigen::MatrixXf;  ///< in single precision

  virtual ~MatrixProducts() = default;
  /// out = a b; out is another matrix than both, of their size.
  /// @param reach  beyond it the factors may be taken for zero
  virtual void multiply(Double const& a, Double const& b, Double& out, Reach reach = {}) const = 0;
  /// The same.
  virtual void multiply(Single const& a, Single const& b, Single& out, Reach reach = {}) const = 0;
  /// At least what is on and below the diagonal of out = a b.
  virtual void multiply_lower(Double const& a, Double const& b, Double& out, Reach reach = {}) const = 0;
  /// The same.
  virtual void multiply_lower(Single const& a, Single const& b, Single& out, Reach reach = {}) const = 0;
};
/// Steps share what multiplies their matrices.
using Products = std::shared_ptr<MatrixProducts const>;

/// Both precisions by one template.
/// @tparam By  has the members `whole(a, b, out)` and `lower(a, b, out)` for matrices of any real numbers, or
///             `whole(a, b, out, reach)` and `lower(a, b, out, reach)`
template <class By>
class ProductsBy : public MatrixProducts {
 public:
  /// By `whole`.
  void multiply(Double const& a, Double const& b, Double& out, Reach reach = {}) const final {
    whole_by(a, b, out, reach);
  }
  /// By `whole`.
  void multiply(Single const& a, Single const& b, Single& out, Reach reach = {}) const final {
    whole_by(a, b, out, reach);
  }
  /// By `lower`.
  void multiply_lower(Double const& a, Double const& b, Double& out, Reach reach = {}) const final {
    lower_by(a, b, out, reach);
  }
  /// By `lower`.
  void multiply_lower(Single const& a, Single const& b, Single& out, Reach reach = {}) const final {
    lower_by(a, b, out, reach);
  }

 private:
  By const& by() const { return static_cast<By const&>(*this); }
  template <class Part>
  void whole_by(Part const& a, Part const& b, Part& out, Reach reach) const {
    if constexpr (requires { by().whole(a, b, out, reach); })
      by().whole(a, b, out, reach);
    else
      by().whole(a, b, out);
  }
  template <class Part>
  void lower_by(Part const& a, Part const& b, Part& out, Reach reach) const {
    if constexpr (requires { by().lower(a, b, out, reach); })
      by().lower(a, b, out, reach);
    else
      by().lower(a, b, out);
  }
};

/// Products of real matrices by Eigen: always there.
class EigenProducts : public ProductsBy<EigenProducts> {
 public:
  /// out = a b.
  template <class Part>
  void whole(Part const& a, Part const& b, Part& out) const;
  /// out = a b, on and below the diagonal.
  template <class Part>
  void lower(Part const& a, Part const& b, Part& out) const;
};

template <class Part>
void EigenProducts::whole(Part const& a, Part const& b, Part& out) const { out.noalias() = a * b; }
template <class Part>
void EigenProducts::lower(Part const& a, Part const& b, Part& out) const {
  out.template triangularView<Eigen::Lower>() = a * b;
}

/// Those that a step has where no others are given.
inline Products eigen_products() {
  static Products const products = std::make_shared<EigenProducts>();
  return products;
}

/// The products of a step, with the memory that they need.
template <class Real>
class SkewProducts {
 public:
  using Part = typename SkewHermitian<Real>::Part;  ///< real matrices

  /// With memory that is taken when the size is known.
  explicit SkewProducts(Products products = eigen_products()) : products_(std::move(products)) {}

  /// B = A W of two skew-Hermitian matrices, whole: three real products. Keeps the commutator
  /// \f$C = [A, W] = B - B^*\f$ beside it.
  /// @param reach  beyond it A and W may be taken for zero
  void multiply(SkewHermitian<Real> const& a, SkewHermitian<Real> const& w, SkewHermitian<Real>& c,
                Reach reach = {}) {
    multiply_half(a, w, c, reach);
    mirror_lower(c);
  }
  /// The same, but of C what is on and below its diagonal.
  void multiply_half(SkewHermitian<Real> const& a, SkewHermitian<Real> const& w, SkewHermitian<Real>& c,
                     Reach reach = {}) {
    auto const n = a.size();
    allocate(n);
    reach_ = reach;
    if (c.size() != n) c = SkewHermitian<Real>(n);
    products_->multiply(a.real, w.real, real_, reach);
    products_->multiply(a.imaginary, w.imaginary, other_, reach);
    sum_ = a.real + a.imaginary, other_sum_ = w.real + w.imaginary;
    products_->multiply(sum_, other_sum_, imaginary_, reach);
    imaginary_ -= real_ + other_;
    real_ -= other_;
    over_tiles(n, [&](auto i, auto j, auto rows, auto columns) {
      c.real.block(i, j, rows, columns) =
          real_.block(i, j, rows, columns) - real_.block(j, i, columns, rows).transpose();
      c.imaginary.block(i, j, rows, columns) =
          imaginary_.block(i, j, rows, columns) + imaginary_.block(j, i, columns, rows).transpose();
    });
  }
  /// Calls `use(real, imaginary)` with the parts of the B of the last product, which it may change.
  template <class Use>
  void with_product(Use const& use) { use(real_, imaginary_); }
  /// E = B A = A W A with the A and the B of the last product: skew-Hermitian, so that half of it is
  /// computed.
  void multiply_again(SkewHermitian<Real> const& a, SkewHermitian<Real>& e) {
    multiply_again_half(a, e);
    mirror_lower(e);
  }
  /// The same, on and below the diagonal.
  void multiply_again_half(SkewHermitian<Real> const& a, SkewHermitian<Real>& e) {
    auto const n = a.size();
    if (e.size() != n) e = SkewHermitian<Real>(n);
    other_sum_ = real_ + imaginary_;
    Reach const reach{reach_.product(), reach_.left};
    products_->multiply_lower(real_, a.real, e.real, reach);
    products_->multiply_lower(imaginary_, a.imaginary, other_, reach);
    products_->multiply_lower(other_sum_, sum_, e.imaginary, reach);
    for (Eigen::Index j = 0; j < n; ++j) {
      auto const below = n - j;
      e.imaginary.col(j).tail(below) -= e.real.col(j).tail(below) + other_.col(j).tail(below);
      e.real.col(j).tail(below) -= other_.col(j).tail(below);
      e.real(j, j) = 0;
    }
  }

 private:
  void allocate(Eigen::Index n) {
    if (real_.rows() == n) return;
    for (Part* part : {&real_, &imaginary_, &other_, &sum_, &other_sum_}) part->resize(n, n);
  }

  Products products_;
  Part real_, imaginary_;  ///< B
  Part sum_;               ///< of the two parts of A
  Part other_, other_sum_;
  Reach reach_;  ///< of A and W
};

// Our own programs have these compiled once (compiled_products.cpp).
extern template void EigenProducts::whole(Eigen::MatrixXd const&, Eigen::MatrixXd const&,
                                          Eigen::MatrixXd&) const;
extern template void EigenProducts::whole(Eigen::MatrixXf const&, Eigen::MatrixXf const&,
                                          Eigen::MatrixXf&) const;
extern template void EigenProducts::lower(Eigen::MatrixXd const&, Eigen::MatrixXd const&,
                                          Eigen::MatrixXd&) const;
extern template void EigenProducts::lower(Eigen::MatrixXf const&, Eigen::MatrixXf const&,
                                          Eigen::MatrixXf&) const;

}  // namespace actio::sphere
