// The two products of a step on SO(n), e e^T and g e^T, of matrices in blocks.
//
// Eight rows by four are added up in registers, from rows of blocks that lie together; sums are cut into
// pieces, so that what is read again and again stays in the caches. No library is needed: on processors with
// two 256-bit multipliers these loops are as fast as OpenBLAS (benchmarks/rigid_body_n.cpp), and the square,
// which half is enough for, costs half a product at any n.
#pragma once

#include <algorithm>

#include "actio/fast_body/any_dimension/blocked_matrix.hpp"

namespace actio::bodies::detail {

/// Adds the columns `from` to `to` of a b^T, for `rows` rows of blocks of a and one of b.
/// @param apart  from one row of blocks to the next
template <int rows>
[[gnu::always_inline]] inline void add_up(double const* a, std::ptrdiff_t apart, double const* b, int from,
                                          int to, FourLanes (&sum)[rows][4]) {
  for (int k = from; k < to; ++k) {
#pragma GCC unroll 4
    for (int c = 0; c < 4; ++c) {
      double const factor = b[4 * k + c];
#pragma GCC unroll 2
      for (int r = 0; r < rows; ++r) sum[r][c] += lanes(a + r * apart + 4 * k) * factor;
    }
  }
}
/// Blocks of a b^T: `rows` of them, one below the other, `below` apart in the result. Where `from` is not
/// zero they are added to what is there.
template <int rows>
[[gnu::always_inline]] inline void product_blocks(double const* a, std::ptrdiff_t apart, double const* b,
                                                  int from, int to, double* result, std::ptrdiff_t below) {
  FourLanes sum[rows][4] = {};
  add_up<rows>(a, apart, b, from, to, sum);
#pragma GCC unroll 2
  for (int r = 0; r < rows; ++r)
#pragma GCC unroll 4
    for (int c = 0; c < 4; ++c) {
      FourLanes& entry = lanes(result + r * below + 4 * c);
      entry = from ? entry + sum[r][c] : sum[r][c];
    }
}
/// One column of blocks of a b^T, rows of blocks from `first` to `last`. `result` is that of the first, and
/// `below` is from one to the next.
template <int B>
[[gnu::always_inline]] inline void product_column(Blocked<B> const& shape, double const* a, double const* b,
                                                  int first, int last, int from, int to, double* result,
                                                  std::ptrdiff_t below) {
  std::ptrdiff_t const apart = 16 * shape.blocks();
  int i = first;
  for (; i + 2 <= last; i += 2, result += 2 * below)
    product_blocks<2>(a + i * apart, apart, b, from, to, result, below);
  if (i < last) product_blocks<1>(a + i * apart, apart, b, from, to, result, below);
}

/// \f$ee^T\f$, of which half is stored.
template <int B>
[[gnu::always_inline]] inline void square_of(Blocked<B> const& shape, double const* e, double* square) {
  int const all = shape.blocks(), columns = shape.n, depth = B ? 4 * B : 256, height = B ? B : 32;
  for (int from = 0; from < columns; from += depth)
    for (int top = 0; top < all; top += height)
      for (int j = 0; j < std::min(all, top + height); ++j) {
        int const first = std::max(top, j);
        product_column(shape, e, e + full_block(shape, j, 0), first, std::min(all, top + height), from,
                       std::min(columns, from + depth), square + half_block(shape, first, j), 16);
      }
}
/// \f$ge^T\f$.
template <int B>
[[gnu::always_inline]] inline void product_of(Blocked<B> const& shape, double const* g, double const* e,
                                              double* product) {
  int const all = shape.blocks(), columns = shape.n, depth = B ? 4 * B : 256, height = B ? B : 32;
  for (int from = 0; from < columns; from += depth)
    for (int top = 0; top < all; top += height)
      for (int j = 0; j < all; ++j)
        product_column(shape, g, e + full_block(shape, j, 0), top, std::min(all, top + height), from,
                       std::min(columns, from + depth), product + full_block(shape, top, j), 16 * all);
}

}  // namespace actio::bodies::detail
