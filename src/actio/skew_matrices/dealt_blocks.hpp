// Matrices dealt out to ranks, block by block, as ScaLAPACK has them.
//
// The ranks are a grid, row after row. Block (I, J) belongs to the rank in row I mod R and column J mod C of
// the grid, and what a rank has is one matrix, columns one after the other.
#pragma once

#include <algorithm>
#include <cstddef>

namespace actio::sphere {

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

  /// Calls `use(i, j, length)` for what a rank has, in the order in which it has it: numbers that follow one
  /// another in a column of the matrix, from (i, j) on.
  template <class Use>
  void visit(int rank, Use const& use) const {
    for (int j0 = rank % columns * block; j0 < size; j0 += columns * block)
      for (int j = j0; j < std::min(size, j0 + block); ++j)
        for (int i = rank / columns * block; i < size; i += rows * block)
          use(i, j, std::min(block, size - i));
  }

 private:
  /// Of all rows or columns, those of one part of the grid.
  int count(int part, int parts) const {
    int const round = parts * block, rest = size % round - part * block;
    return size / round * block + std::clamp(rest, 0, block);
  }
};

}  // namespace actio::sphere
