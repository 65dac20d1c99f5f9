// The lattice of the multigrid solver of incompressible media: two colours, and how their numbers lie in
// memory.
//
// Cells (i, j) of squares that share an edge do not act on each other, only those that share nothing but a
// corner: the cells fall apart into two lattices like the colours of a chess board, each of them turned by 45
// degrees. A site (I, J), I + J even, holds a red cell and a black one; of the finest lattice these are
// (I, J) and (I, J + 1). Along the diagonals sites have the coordinates u = (I+J)/2 and v = (I-J)/2, and
// every second u and v makes the sites of the next lattice, (I, J) -> (I/2, J/2).
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>

#include "actio/parallel/ranks.hpp"

namespace actio::media::detail {

/// A site, along the diagonals.
struct Diagonals {
  int u, v;  ///< (I+J)/2 and (I-J)/2
  /// I.
  int column() const { return u + v; }
  /// J.
  int row() const { return u - v; }
  /// Of site (I, J).
  static Diagonals of(int column, int row) { return {(column + row) >> 1, (column - row) >> 1}; }
};

/// Floats that the loops of the cycle take at a time.
inline constexpr int lanes = 8;

/// A lattice of sites with the place of each in memory.
///
/// Site number k of row J is I = 2k + (J odd). A row is stored by the parity of k, so that the sites of one
/// parity of u and of v, which do not act on each other, are contiguous: k = 2a + p has place a of part p.
/// Around the sites there is room for those that are not there, where fields are zero, or copies of the
/// other end along a periodic direction.
struct TwoColourLattice {
  int columns = 0;                 ///< I is from 0 up to this
  std::array<int, 2> from{};       ///< the first row that has a red cell, a black cell
  std::array<int, 2> to{};         ///< the row after the last
  std::array<bool, 2> periodic{};  ///< the directions along which it closes

  /// Of a box of cells.
  static TwoColourLattice of_cells(std::array<int, 2> n, std::array<bool, 2> closes) {
    int const below = closes[1] ? 0 : -1;
    return {n[0], {0, below}, {n[1], n[1] + below}, closes};
  }
  /// The next one.
  TwoColourLattice coarse() const {
    return {(columns + 1) / 2, {0, 0}, {(to[0] + 1) / 2, (to[1] + 1) / 2}, periodic};
  }
  /// Whether the next one has both colours in step round the periodic directions.
  bool can_be_coarsened() const {
    return (!periodic[0] || columns % 4 == 0) && (!periodic[1] || to[0] % 4 == 0);
  }
  /// The first row with any cell, and the row after the last.
  int low() const { return std::min(from[0], from[1]); }
  int high() const { return std::max(to[0], to[1]); }  ///< \copydoc low
  /// Whether a site has a cell of this colour; along a periodic direction it always has.
  bool holds(int colour, Diagonals s) const {
    auto const c = static_cast<std::size_t>(colour);
    return (periodic[0] || (s.column() >= 0 && s.column() < columns)) &&
           (periodic[1] || (s.row() >= from[c] && s.row() < to[c]));
  }
  /// The same site within one period.
  Diagonals wrapped(Diagonals s) const {
    int i = s.column(), j = s.row();
    if (periodic[0]) i = (i % columns + columns) % columns;
    if (periodic[1]) j = (j % to[0] + to[0]) % to[0];
    return Diagonals::of(i, j);
  }

  /// Sites of a row, at most.
  int sites() const { return (columns + 1) / 2; }
  /// Times that a loop of `lanes` goes over a part of a row.
  int blocks() const { return ((sites() + 1) / 2 + lanes - 1) / lanes; }
  /// From one part of a row to the next.
  std::ptrdiff_t stride() const { return lanes * (blocks() + 1); }
  /// Where part p of row J of a field begins, if each site has so many numbers, of this one.
  std::ptrdiff_t part(int numbers, int row, int p, int number) const {
    return (((row + 3) * 2 + p) * numbers + number) * stride() + lanes / 2;
  }
  /// Where number `number` of a site is; also of sites one step out of the lattice.
  std::ptrdiff_t at(int numbers, Diagonals s, int number) const {
    int const k = (s.column() - (s.row() & 1)) >> 1;
    return part(numbers, s.row(), k & 1, number) + (k >> 1);
  }
  /// Room for a field; loops go past its end by less than the second term.
  std::size_t room(int numbers) const {
    return static_cast<std::size_t>(part(numbers, high() + 2, 0, 0) + 4 * lanes);
  }
  /// Which of the two sites of class (u, v) = (J + q, q) modulo 2 the part of row J is.
  static int part_of_class(int row, int q) { return (q + ((row + (row & 1)) >> 1)) & 1; }

  /// Calls f(site) for each site, row by row.
  template <class F>
  void each_site(F const& f) const { each_site({low(), high()}, f); }
  /// The same of some rows, of which those beyond an end of a period are those of the other end; others that
  /// are not there are left out. Rows come in ascending order within one period.
  template <class F>
  void each_site(RowRange const& rows, F const& f) const {
    auto const over = [&](int from, int to) {
      for (int j = std::max(from, low()); j < std::min(to, high()); ++j)
        for (int i = j & 1; i < columns; i += 2) f(Diagonals::of(i, j));
    };
    if (rows.count() >= high() - low()) return over(low(), high());
    if (periodic[1]) over(low(), rows.to - to[0]);
    over(rows.from, rows.to);
    if (periodic[1]) over(rows.from + to[0], high());
  }
};

}  // namespace actio::media::detail
