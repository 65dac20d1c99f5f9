// The rank of a matrix, by elimination with full pivoting: exact over the rationals, up to rounding
// elsewhere.
#pragma once

#include "actio/linear_algebra/linear.hpp"

namespace actio {

/// The rank of a matrix: how many pivots stand out of rounding, 256 n epsilon of the largest entry.
///
/// \snippet numbers.cpp matrix_rank
template <MatrixLike M>
int matrix_rank(M const& matrix) {
  using S = typename M::Scalar;
  Matrix<S, Dynamic, Dynamic> a = matrix;
  int const rows = static_cast<int>(a.rows()), columns = static_cast<int>(a.cols()),
            largest = rows > columns ? rows : columns;
  Base<S> const tiny = Base<S>(256 * largest) * epsilon<S>() * magnitude(a);
  int rank = 0;
  for (; rank < rows && rank < columns; ++rank) {
    int row = rank, column = rank;
    for (int i = rank; i < rows; ++i)
      for (int c = rank; c < columns; ++c)
        if (magnitude(a(i, c)) > magnitude(a(row, column))) row = i, column = c;
    if (!(magnitude(a(row, column)) > tiny)) break;
    a.row(rank).swap(a.row(row)), a.col(rank).swap(a.col(column));
    for (int i = rank + 1; i < rows; ++i) {
      S const factor = a(i, rank) / a(rank, rank);
      for (int c = rank; c < columns; ++c) a(i, c) -= factor * a(rank, c);
    }
  }
  return rank;
}

}  // namespace actio
