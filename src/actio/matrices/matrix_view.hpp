// Views: numbers that lie elsewhere, seen as a matrix. Included by matrix.hpp, which defines what a view is
// copied into.
#pragma once

#include <cassert>
#include <type_traits>

#include "actio/matrices/matrix_operations.hpp"

namespace actio {

/// R rows and C columns of numbers that lie elsewhere, `inner` apart down a column and `outer` apart along a
/// row. S is constant where they may only be read.
template <class S, int R, int C>
struct MatrixView : detail::MatrixOperations<MatrixView<S, R, C>, std::remove_const_t<S>, R, C> {
  /// @param inner  from one number to the next down a column
  /// @param outer  from one number to the next along a row
  MatrixView(S* first, Index rows, Index columns, Index inner, Index outer)
      : first_(first), rows_(rows), columns_(columns), inner_(inner), outer_(outer) {}
  /// The same numbers, seen twice.
  MatrixView(MatrixView const&) = default;
  /// Numbers take their places one by one; of another part of the same matrix, too.
  MatrixView& operator=(MatrixView const& b) { return assign(b); }
  /// Numbers take their places one by one.
  template <MatrixLike B>
  MatrixView& operator=(B const& b) { return assign(b); }

  /// How many rows.
  Index rows() const { return R == Dynamic ? rows_ : R; }
  /// How many columns.
  Index cols() const { return C == Dynamic ? columns_ : C; }
  /// From one number to the next down a column.
  Index rowStride() const { return inner_; }
  /// From one number to the next along a row.
  Index colStride() const { return outer_; }
  /// From one number of a vector to the next.
  Index along() const { return R == 1 ? outer_ : inner_; }
  /// The first number.
  S* data() const { return first_; }
  /// The number in row i and column j.
  S& operator()(Index i, Index j) const {
    assert(detail::is_index(i, rows()) && detail::is_index(j, cols()));
    return first_[i * inner_ + j * outer_];
  }
  /// The k-th number of a vector.
  S& operator()(Index k) const {
    assert(detail::is_index(k, rows() * cols()));
    return first_[k * along()];
  }
  /// The k-th number of a vector.
  S& operator[](Index k) const { return (*this)(k); }

  /// The same numbers as a matrix of Eigen.
  template <int r, int c, int options, int most_rows, int most_columns>
    requires(detail::may_be<MatrixView, r, c>)
  operator Eigen::Matrix<std::remove_const_t<S>, r, c, options, most_rows, most_columns>() const {
    return this->eval();
  }

 private:
  S* first_;
  Index rows_, columns_, inner_, outer_;

  template <class B>
  MatrixView& assign(B const& b) {
    typename B::PlainObject const copy = b;
    for (Index j = 0; j < cols(); ++j)
      for (Index i = 0; i < rows(); ++i) (*this)(i, j) = copy(i, j);
    return *this;
  }
};

/// Numbers that lie one after the other, as a matrix of R rows and C columns, column by column.
template <int R, int C, class S>
MatrixView<S, R, C> as_matrix(S* first) { return {first, R, C, 1, R}; }
/// Numbers that lie one after the other, as a column of n.
template <class S>
MatrixView<S, Dynamic, 1> as_vector(S* first, Index n) { return {first, n, 1, 1, n}; }

}  // namespace actio
