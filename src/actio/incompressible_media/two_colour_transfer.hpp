// Between the numbers of the cells of a box and a field of the finest lattice of the multigrid solver.
#pragma once

#include <cmath>
#include <type_traits>

#include "actio/incompressible_media/two_colour_level.hpp"
#include "actio/numbers/registers.hpp"

namespace actio::media::detail {

/// Eight doubles.
using Doubles [[gnu::vector_size(64)]] = double;
/// Their number.
constexpr std::size_t eight = 8;

/// The same anywhere in memory.
using DoublesThere [[gnu::vector_size(64), gnu::aligned(8), gnu::may_alias]] = double;

[[gnu::always_inline]] inline DoublesThere const& load_eight(double const* from) {
  return *reinterpret_cast<DoublesThere const*>(from);
}

/// The largest modulus of some numbers and their sum.
struct Size {
  double const* x;              ///< the numbers
  std::size_t count;            ///< how many
  double largest = 0, sum = 0;  ///< on return; the sum is not finite where a number is not

  [[gnu::always_inline]] void operator()() {
    Doubles most{}, total{};
    std::size_t k = 0;
    for (; k + eight <= count; k += eight) {
      Doubles const y = load_eight(x + k), size = y < 0 ? -y : y;
      most = size > most ? size : most, total += y;
    }
    for (std::size_t n = 0; n < eight; ++n) largest = std::max(largest, most[n]), sum += total[n];
    for (; k < count; ++k) largest = std::max(largest, std::abs(x[k])), sum += x[k];
  }
};
/// Those of all ranks, row by row, so that the sum is the same on any number of them.
inline Size size_of(double const* x, RowShare const& rows, int columns, Registers registers) {
  Size out{x, 0};
  double largest = 0;
  out.sum = rows.sum([&](int j) {
    Size one{x + static_cast<std::ptrdiff_t>(j) * columns, static_cast<std::size_t>(columns)};
    run_with(registers, one);
    largest = std::max(largest, one.largest);
    return one.sum;
  });
  out.largest = rows.most(largest);
  return out;
}

/// Between the numbers of the cells, row by row, and a field of the finest lattice.
///
/// Cell i of a row has the colour of i plus the row modulo two, and is in part floor(i/2) modulo 2 at i/4.
template <bool in>
struct Transfer {
  using Cells = std::conditional_t<in, double const, double>;
  TwoColourLattice const& lattice;  ///< the finest one
  float* field;                     ///< of it, two numbers a site
  Cells* cells;                     ///< the numbers of the cells
  int columns, rows;                ///< of cells
  Ranges const& through;            ///< rows that are gone through
  double factor;                    ///< by which they are multiplied
  double more = 0;                  ///< what is added to the numbers of the cells

  [[gnu::always_inline]] void operator()() {
    constexpr int width = 4 * lanes;
    double end[width] = {};
    for (RowRange const& range : through)
      for (int j = range.from; j < range.to; ++j)
        for (int i = 0; i < columns; i += width) {
          Cells* const at = cells + static_cast<std::ptrdiff_t>(j) * columns + i;
          if (i + width <= columns) {
            four(at, j, i / 4);
            continue;
          }
          std::size_t const bytes = sizeof(double) * static_cast<std::size_t>(columns - i);
          if constexpr (in) std::memcpy(end, at, bytes);
          four(static_cast<Cells*>(end), j, i / 4);
          if constexpr (!in) std::memcpy(at, end, bytes);
        }
  }

 private:
  /// Where the cells of a row with i modulo 4 = n are.
  [[gnu::always_inline]] float* part(int j, int n) const {
    int const c = (j + n) & 1;
    int const row = j == 0 && c == 1 && lattice.periodic[1] ? rows - 1 : j - c;
    return field + lattice.part(2, row, n >> 1, c);
  }
  [[gnu::always_inline]] void four(Cells* at, int j, int a) {
    Floats x[4], half[4];
    if constexpr (in) {
      for (int n = 0; n < 4; ++n)
        for (int k = 0; k < lanes; ++k) x[n][k] = static_cast<float>(factor * (at[lanes * n + k] + more));
      part_pairs(x[0], x[1], half[0], half[1]), part_pairs(x[2], x[3], half[2], half[3]);
      part_pairs(half[0], half[2], x[0], x[2]), part_pairs(half[1], half[3], x[1], x[3]);
      for (int n = 0; n < 4; ++n) store(part(j, n) + a, x[n]);
    } else {
      for (int n = 0; n < 4; ++n) x[n] = load(part(j, n) + a);
      join_pairs(x[0], x[2], half[0], half[2]), join_pairs(x[1], x[3], half[1], half[3]);
      join_pairs(half[0], half[1], x[0], x[1]), join_pairs(half[2], half[3], x[2], x[3]);
      for (int n = 0; n < 4; ++n)
        for (int k = 0; k < lanes; ++k) at[lanes * n + k] = factor * static_cast<double>(x[n][k]) + more;
    }
  }
};

}  // namespace actio::media::detail
