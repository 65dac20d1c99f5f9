// Matrices dealt out to ranks, block by block, as ScaLAPACK has them.
//
// The ranks are a grid, row after row. Block (I, J) belongs to the rank in row I mod R and column J mod C of
// the grid, and what a rank has is one matrix, columns one after the other.
#pragma once

#include <algorithm>
#include <cstddef>

namespace actio::sphere {

/// What of a matrix is not known to be zero, or is wanted: this many diagonals on both sides of the main one.
struct DealtBand {
  int above;  ///< above it
  int below;  ///< below it
};

/// How a square matrix is dealt out.
struct DealtBlocks {
  int size;     ///< N, of the matrix
  int block;    ///< rows and columns of a block; the last ones may have fewer
  int rows;     ///< R, of the grid
  int columns;  ///< C, of the grid

  /// On the grid nearest to a square, with four blocks or more for each of its columns where N has room for
  /// them: then all ranks have about the same.
  static DealtBlocks of(int size, int ranks) {
    int rows = 1;
    for (int r = 2; r * r <= ranks; ++r)
      if (ranks % r == 0) rows = r;
    int const columns = ranks / rows;
    return {size, std::clamp(size / (4 * columns) / 8 * 8, 8, 128), rows, columns};
  }

  /// Rows of the matrix that a rank has.
  int rows_of(int rank) const { return count(rank / columns, rows); }
  /// Columns of the matrix that a rank has.
  int columns_of(int rank) const { return count(rank % columns, columns); }
  /// Numbers of the matrix that a rank has.
  std::size_t numbers_of(int rank) const {
    return static_cast<std::size_t>(rows_of(rank)) * static_cast<std::size_t>(columns_of(rank));
  }

  /// Calls `use(i, j, length, at)` for what a rank has in the blocks of a band: numbers that follow one
  /// another in a column of the matrix, from (i, j) on, and in what the rank has, from `at` on.
  template <class Use>
  void visit(int rank, DealtBand band, Use const& use) const {
    auto const height = static_cast<std::size_t>(rows_of(rank));
    std::size_t column = 0;
    for (int first = rank % columns * block; first < size; first += columns * block)
      for (int j = first; j < std::min(size, first + block); ++j, ++column) {
        std::size_t at = column * height;
        for (int i = rank / columns * block; i < size; i += rows * block) {
          int const length = std::min(block, size - i);
          if (first - (i + length - 1) <= band.above && i - (first + block - 1) <= band.below)
            use(i, j, length, at);
          at += static_cast<std::size_t>(length);
        }
      }
  }

 private:
  /// Of all rows or columns, those of one part of the grid.
  int count(int part, int parts) const {
    int const round = parts * block, rest = size % round - part * block;
    return size / round * block + std::clamp(rest, 0, block);
  }
};

}  // namespace actio::sphere
