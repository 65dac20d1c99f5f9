// Where the numbers of a matrix are, and how they are written into it row by row.
#pragma once

#include <cstddef>
#include <utility>
#include <vector>

#include "actio/matrices/matrix_like.hpp"

namespace actio::detail {

/// Entries of a matrix of fixed size.
template <class S, int R, int C>
struct MatrixEntries {
  S entry[R * C > 0 ? R* C : 1];

  static constexpr Index rows() { return R; }
  static constexpr Index cols() { return C; }
  S* data() { return entry; }
  S const* data() const { return entry; }
  void set_size(Index, Index) {}
};
/// Entries of a matrix whose size is known when the program runs.
template <class S, int R, int C>
  requires(R == Dynamic || C == Dynamic)
struct MatrixEntries<S, R, C> {
  std::vector<S> entry;
  Index row_count = R == Dynamic ? 0 : R, column_count = C == Dynamic ? 0 : C;

  Index rows() const { return row_count; }
  Index cols() const { return column_count; }
  S* data() { return entry.data(); }
  S const* data() const { return entry.data(); }
  void set_size(Index r, Index c) {
    row_count = r, column_count = c;
    entry.resize(static_cast<std::size_t>(r * c));
  }
};

/// Fills a matrix row by row: `m << a, b, c, d`. What follows may be numbers, or matrices that stand side by
/// side.
template <class M>
struct MatrixFiller {
  M& matrix;
  Index row = 0, column = 0, height = 1;

  template <class T>
  MatrixFiller& operator,(T const& x) {
    if (column == matrix.cols()) row += height, column = 0;
    if constexpr (MatrixLike<T>) {
      for (Index i = 0; i < x.rows(); ++i)
        for (Index j = 0; j < x.cols(); ++j) matrix(row + i, column + j) = x(i, j);
      if (x.cols() > 0) height = x.rows(), column += x.cols();
    } else {
      matrix(row, column) = x;
      height = 1, ++column;
    }
    return *this;
  }
  /// The matrix.
  M& finished() { return matrix; }
};

/// The numbers of a matrix one by one, for `m.diagonal().array() += c`.
template <class S>
struct NumbersOf {
  S* first;
  Index rows, columns, inner, outer;

  template <class T>
  void operator+=(T c) {
    for (Index j = 0; j < columns; ++j)
      for (Index i = 0; i < rows; ++i) first[i * inner + j * outer] += c;
  }
  template <class T>
  void operator-=(T c) {
    for (Index j = 0; j < columns; ++j)
      for (Index i = 0; i < rows; ++i) first[i * inner + j * outer] -= c;
  }
};

}  // namespace actio::detail
