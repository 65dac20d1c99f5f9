// The parts of a matrix or of a view of one: rows, columns, blocks, the diagonal; its transpose, its numbers
// in another shape.
#pragma once

#include <algorithm>
#include <concepts>
#include <type_traits>

#include "actio/matrices/matrix_numbers.hpp"

namespace actio::detail {

/// Parts of a matrix or of a view of one: M is either.
template <class M, class S, int R, int C>
struct MatrixParts : MatrixNumbers<M, S, R, C> {
  using Numbers = MatrixNumbers<M, S, R, C>;
  using Numbers::at, Numbers::cols, Numbers::lying, Numbers::rows, Numbers::self, Numbers::size;
  using typename Numbers::PlainObject;

  /// Rows and columns exchanged: a copy.
  auto transpose() const {
    Matrix<S, C, R> m(self().cols(), self().rows(), Sized{});
    for (Index j = 0; j < m.cols(); ++j)
      for (Index i = 0; i < m.rows(); ++i) m(i, j) = at(j, i);
    return m;
  }

/// @cond
// A part of a matrix that can be changed, of one that cannot, and of a temporary one, of which it is a copy
// unless that is a view itself. In each the matrix is m; the part has `part_rows` and `part_columns` known
// when this is compiled, begins at (i0, j0) and has r0 rows and c0 columns.
#define ACTIO_PART(part_rows, part_columns, i0, j0, r0, c0, ...)                       \
  __VA_ARGS__& { return view<part_rows, part_columns>(self(), i0, j0, r0, c0); }       \
  __VA_ARGS__ const& { return view<part_rows, part_columns>(self(), i0, j0, r0, c0); } \
  __VA_ARGS__&& {                                                                      \
    if constexpr (std::same_as<M, PlainObject>)                                        \
      return view<part_rows, part_columns>(self(), i0, j0, r0, c0).eval();             \
    else                                                                               \
      return view<part_rows, part_columns>(self(), i0, j0, r0, c0);                    \
  }
  ACTIO_PART(R, 1, 0, j, rows(), 1, auto col(Index j))
  ACTIO_PART(1, C, i, 0, 1, cols(), auto row(Index i))
  ACTIO_PART(Dynamic, Dynamic, i, j, r, c, auto block(Index i, Index j, Index r, Index c))
  ACTIO_PART(r, c, i, j, r, c, template <int r, int c> auto block(Index i, Index j))
  ACTIO_PART(Dynamic, C, 0, 0, r, cols(), auto topRows(Index r))
  ACTIO_PART(r, C, 0, 0, r, cols(), template <int r> auto topRows())
  ACTIO_PART(Dynamic, C, i, 0, r, cols(), auto middleRows(Index i, Index r))
  ACTIO_PART(r, C, i, 0, r, cols(), template <int r> auto middleRows(Index i))
  ACTIO_PART(Dynamic, C, rows() - r, 0, r, cols(), auto bottomRows(Index r))
  ACTIO_PART(r, C, rows() - r, 0, r, cols(), template <int r> auto bottomRows())
  ACTIO_PART(R, Dynamic, 0, 0, rows(), c, auto leftCols(Index c))
  ACTIO_PART(R, c, 0, 0, rows(), c, template <int c> auto leftCols())
  ACTIO_PART(R, Dynamic, 0, j, rows(), c, auto middleCols(Index j, Index c))
  ACTIO_PART(R, c, 0, j, rows(), c, template <int c> auto middleCols(Index j))
  ACTIO_PART(R, Dynamic, 0, cols() - c, rows(), c, auto rightCols(Index c))
  ACTIO_PART(R, c, 0, cols() - c, rows(), c, template <int c> auto rightCols())
  ACTIO_PART(Dynamic, Dynamic, 0, 0, r, c, auto topLeftCorner(Index r, Index c))
  ACTIO_PART(r, c, 0, 0, r, c, template <int r, int c> auto topLeftCorner())
  ACTIO_PART(Dynamic, Dynamic, 0, cols() - c, r, c, auto topRightCorner(Index r, Index c))
  ACTIO_PART(r, c, 0, cols() - c, r, c, template <int r, int c> auto topRightCorner())
  ACTIO_PART(Dynamic, Dynamic, rows() - r, 0, r, c, auto bottomLeftCorner(Index r, Index c))
  ACTIO_PART(r, c, rows() - r, 0, r, c, template <int r, int c> auto bottomLeftCorner())
  ACTIO_PART(Dynamic, Dynamic, rows() - r, cols() - c, r, c, auto bottomRightCorner(Index r, Index c))
  ACTIO_PART(r, c, rows() - r, cols() - c, r, c, template <int r, int c> auto bottomRightCorner())
#undef ACTIO_PART
// The same along a vector, from place k0 on.
#define ACTIO_PART(length, k0, n0, ...)                                                                   \
  __VA_ARGS__& {                                                                                          \
    return view < lying ? 1 : length,                                                                     \
           lying ? length : 1 > (self(), lying ? 0 : k0, lying ? k0 : 0, lying ? 1 : n0, lying ? n0 : 1); \
  }                                                                                                       \
  __VA_ARGS__ const& {                                                                                    \
    return view < lying ? 1 : length,                                                                     \
           lying ? length : 1 > (self(), lying ? 0 : k0, lying ? k0 : 0, lying ? 1 : n0, lying ? n0 : 1); \
  }                                                                                                       \
  __VA_ARGS__&& {                                                                                         \
    auto part = view < lying ? 1 : length,                                                                \
         lying ? length : 1 > (self(), lying ? 0 : k0, lying ? k0 : 0, lying ? 1 : n0, lying ? n0 : 1);   \
    if constexpr (std::same_as<M, PlainObject>)                                                           \
      return part.eval();                                                                                 \
    else                                                                                                  \
      return part;                                                                                        \
  }
  ACTIO_PART(Dynamic, k, n, auto segment(Index k, Index n))
  ACTIO_PART(n, k, n, template <int n> auto segment(Index k))
  ACTIO_PART(Dynamic, 0, n, auto head(Index n))
  ACTIO_PART(n, 0, n, template <int n> auto head())
  ACTIO_PART(Dynamic, size() - n, n, auto tail(Index n))
  ACTIO_PART(n, size() - n, n, template <int n> auto tail())
#undef ACTIO_PART
  /// @endcond
  auto diagonal() & { return diagonal_of(self()); }
  auto diagonal() const& { return diagonal_of(self()); }
  auto diagonal() && { return diagonal_of(self()).eval(); }
  /// All numbers as one column, column by column.
  auto reshaped() const {
    Matrix<S, Numbers::SizeAtCompileTime, 1> v(size(), 1, Sized{});
    Index k = 0;
    for (Index j = 0; j < self().cols(); ++j)
      for (Index i = 0; i < self().rows(); ++i) v[k++] = at(i, j);
    return v;
  }

  /// The numbers, column by column, as r rows and c columns.
  auto reshaped(Index r, Index c) const {
    Matrix<S> m(r, c, Sized{});
    for (Index k = 0; k < size(); ++k) m.data()[k] = at(k % self().rows(), k / self().rows());
    return m;
  }

 private:
  template <int r, int c, class Whole>
  static auto view(Whole& m, Index i, Index j, Index r0, Index c0) {
    using Entry = std::remove_reference_t<decltype(*m.data())>;
    return MatrixView<Entry, r, c>(m.data() + i * m.rowStride() + j * m.colStride(), r0, c0, m.rowStride(),
                                   m.colStride());
  }
  template <class Whole>
  static auto diagonal_of(Whole& m) {
    using Entry = std::remove_reference_t<decltype(*m.data())>;
    return MatrixView<Entry, R, 1>(m.data(), std::min(m.rows(), m.cols()), 1, m.rowStride() + m.colStride(),
                                   m.colStride());
  }
};

}  // namespace actio::detail
