// Symmetric matrices on a box of cells that couple each cell with the eight around it: what the pressures of
// an incompressible medium are found from.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

namespace actio::media {

/// A symmetric matrix on the cells of a box, with entries between cells that share a corner.
///
/// Cell (i, j) is number i + n0 j. Each pair of cells is stored once, at the first of the two; entries that
/// lead out of the box are zero and stay so. Along a periodic direction the last cell is the neighbour of the
/// first.
struct NinePointMatrix {
  std::array<int, 2> cells{};      ///< n0 along a row and n1 rows, at least two each
  std::array<bool, 2> periodic{};  ///< the directions along which the box closes
  std::vector<double> self;        ///< the diagonal
  std::vector<double> east;        ///< between (i, j) and (i+1, j)
  std::vector<double> north;       ///< between (i, j) and (i, j+1)
  std::vector<double> north_east;  ///< between (i, j) and (i+1, j+1)
  std::vector<double> north_west;  ///< between (i, j) and (i-1, j+1)

  NinePointMatrix() = default;
  /// The zero matrix of a box of these cells.
  explicit NinePointMatrix(std::array<int, 2> n, std::array<bool, 2> closes = {})
      : cells(n),
        periodic(closes),
        self(size()),
        east(self),
        north(self),
        north_east(self),
        north_west(self) {}

  /// How many cells there are.
  std::size_t size() const { return static_cast<std::size_t>(cells[0]) * static_cast<std::size_t>(cells[1]); }
  /// The number of cell (i, j), which may be one step out of the box along a periodic direction.
  std::size_t at(int i, int j) const {
    i += i < 0           ? cells[0]
         : i >= cells[0] ? -cells[0]
                         : 0,
        j += j < 0           ? cells[1]
             : j >= cells[1] ? -cells[1]
                             : 0;
    return static_cast<std::size_t>(j) * static_cast<std::size_t>(cells[0]) + static_cast<std::size_t>(i);
  }
  /// Whether there is a cell (i, j), the box repeated along its periodic directions.
  bool holds(int i, int j) const {
    return (periodic[0] || (i >= 0 && i < cells[0])) && (periodic[1] || (j >= 0 && j < cells[1]));
  }
  /// Calls f(a, i', j') for the entry a of cell (i, j) with each of the eight cells (i', j') around it that
  /// there are.
  template <class F>
  void each_neighbour(int i, int j, F const& f) const {
    std::size_t const k = at(i, j);
    auto const later = [&](std::vector<double> const& a, int x, int y) {
      if (holds(i + x, j + y)) f(a[k], i + x, j + y);
      if (holds(i - x, j - y)) f(a[at(i - x, j - y)], i - x, j - y);
    };
    later(east, 1, 0), later(north, 0, 1), later(north_east, 1, 1), later(north_west, -1, 1);
  }
  /// The entry of S x at cell (i, j).
  double product(double const* x, int i, int j) const {
    double sum = self[at(i, j)] * x[at(i, j)];
    each_neighbour(i, j, [&](double a, int i1, int j1) { sum += a * x[at(i1, j1)]; });
    return sum;
  }
  /// out = S x, both with an entry for each cell.
  void product(double const* x, double* out) const;
  /// out = b - S x; b may be out.
  void residual(double const* b, double const* x, double* out) const;
};

}  // namespace actio::media
