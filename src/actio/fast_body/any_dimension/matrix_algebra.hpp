// What is done with whole matrices in blocks: products, commutators, and the sums that tell how large they
// are.
#pragma once

#include <cmath>

#include "actio/fast_body/any_dimension/block_products.hpp"

namespace actio::bodies::detail {

template <int B>
ACTIO_FOR_AVX2 void product_avx2(int n, double const* g, double const* e, double* product) {
  product_of(Blocked<B>(n), g, e, product);
}
template <int B>
void product_plain(int n, double const* g, double const* e, double* product) {
  product_of(Blocked<B>(n), g, e, product);
}

/// Full matrices of one size. Results lie elsewhere than factors, where nothing else is said.
class MatrixAlgebra {
 public:
  explicit MatrixAlgebra(int n, Machine machine = best_machine());
  Blocked<0> const& shape() const { return shape_; }
  /// How many numbers a matrix has here.
  std::size_t size() const { return size_; }

  /// \f$ab^T\f$; a and b may be one.
  void times_transposed(double const* a, double const* b, double* result) const {
    product_(shape_.n, a, b, result);
  }
  /// \f$t - t^T\f$ in place of t: for t = a b^T with skew a and b it is \f$-[a,b]\f$.
  void subtract_transposed(double* t) const;
  /// \f$t^T\f$ in place of t.
  void transpose_in_place(double* t) const {
    pairs(t, [](FourLanes& x, FourLanes& y) { std::swap(x, y); });
  }
  /// The skew half of a matrix, in its place.
  void make_skew(double* t) const {
    subtract_transposed(t);
    scale(0.5, t);
  }
  void scale(double factor, double* a) const {
    for (std::size_t at = 0; at < size_; at += 4) lanes(a + at) *= factor;
  }
  /// Adds a multiple of a to b.
  void add(double factor, double const* a, double* b) const {
    for (std::size_t at = 0; at < size_; at += 4) lanes(b + at) += lanes(a + at) * factor;
  }
  /// Entry by entry.
  void multiply_entries(double const* factors, double* a) const {
    for (std::size_t at = 0; at < size_; at += 4) lanes(a + at) *= lanes(factors + at);
  }
  void add_identity(double* a) const {
    for (int i = 0; i < shape_.n; ++i) a[full_entry(shape_, i, i)] += 1;
  }
  /// The norm of Frobenius.
  double norm(double const* a) const {
    FourLanes squares = {};
    for (std::size_t at = 0; at < size_; at += 4) squares += lanes(a + at) * lanes(a + at);
    return std::sqrt(sum(squares));
  }

 private:
  /// Columns of t and of its transpose, four entries each: what becomes of the first, and of the second at
  /// the mirror image.
  template <class Change>
  void pairs(double* t, Change const& change) const {
    for (int j = 0; j < shape_.blocks(); ++j)
      for (int i = j; i < shape_.blocks(); ++i) {
        double *const below = t + full_block(shape_, i, j), *const above = t + full_block(shape_, j, i);
        FourLanes mirror[4];
        for (int c = 0; c < 4; ++c) mirror[c] = lanes(above + 4 * c);
        transpose(mirror);
        for (int c = 0; c < 4; ++c) change(lanes(below + 4 * c), mirror[c]);
        if (i == j) continue;
        transpose(mirror);
        for (int c = 0; c < 4; ++c) lanes(above + 4 * c) = mirror[c];
      }
  }

  Blocked<0> shape_;
  std::size_t size_;
  void (*product_)(int, double const*, double const*, double*);
};

}  // namespace actio::bodies::detail
