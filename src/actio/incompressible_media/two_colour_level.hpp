// A lattice of the multigrid solver with its matrix in single precision, and the loops of the cycle over it.
//
// All loops go along parts of rows, lane by lane, with the same terms for all sites of a part: where a site
// is missing its coefficients are zero.
#pragma once

#include <cstring>
#include <vector>

#include "actio/incompressible_media/two_colour_coarsening.hpp"
#include "actio/parallel/row_share.hpp"

namespace actio::media::detail {

/// As many floats as a loop takes at a time.
using Floats [[gnu::vector_size(4 * lanes)]] = float;

/// The same anywhere in memory.
using FloatsThere [[gnu::vector_size(4 * lanes), gnu::aligned(4), gnu::may_alias]] = float;

[[gnu::always_inline]] inline FloatsThere const& load(float const* from) {
  return *reinterpret_cast<FloatsThere const*>(from);
}
[[gnu::always_inline]] inline void store(float* to, Floats const& x) { std::memcpy(to, &x, sizeof x); }
/// The numbers 0, 2, 4, ... of two registers, and 1, 3, 5, ...
[[gnu::always_inline]] inline void part_pairs(Floats const& x, Floats const& y, Floats& even, Floats& odd) {
  even = __builtin_shufflevector(x, y, 0, 2, 4, 6, 8, 10, 12, 14);
  odd = __builtin_shufflevector(x, y, 1, 3, 5, 7, 9, 11, 13, 15);
}
/// The inverse of \ref part_pairs.
[[gnu::always_inline]] inline void join_pairs(Floats const& even, Floats const& odd, Floats& x, Floats& y) {
  x = __builtin_shufflevector(even, odd, 0, 8, 1, 9, 2, 10, 3, 11);
  y = __builtin_shufflevector(even, odd, 4, 12, 5, 13, 6, 14, 7, 15);
}

/// An entry that is stored at cells of one colour: with the cell of another colour that many sites further.
struct StoredEntry {
  int from, to, du, dv;  ///< the colours, and how many sites further along u and v
};
/// What is stored of a matrix, besides the inverse diagonal of both colours: each pair of cells once.
std::vector<StoredEntry> const& stored_entries(bool of_cells);

/// A term of a row of the matrix: where its coefficient is, and the number that it multiplies.
struct Term {
  std::ptrdiff_t coefficient, number;  ///< from where those of the first cell of the part are
};
/// The terms of the cells of one colour in one part of a row, the diagonal apart: first those with cells that
/// the first sweep comes to before them.
struct Terms {
  std::array<Term, 17> term;  ///< in this order
  int before = 0, count = 0;  ///< how many are with cells that come before, and in all
};

/// An entry of P beside the bilinear weights.
struct RimWeight {
  std::ptrdiff_t fine, coarse;  ///< places in a field of the fine lattice and in the rows of the coarse one
  int fine_row, coarse_row;     ///< rows of these
  float weight;                 ///< that is added to the bilinear one
};

/// Sites of the coarse lattice from which the sites of one part of a row are interpolated.
struct PartParents {
  std::array<std::ptrdiff_t, 4> place{};  ///< of that of the first site, from the beginning of the coarse row
  int count = 0;                          ///< one, two or four of the same weight
};

/// A lattice with its matrix and the fields of a cycle.
///
/// Of a lattice that is shared, a rank goes over its own rows, and has two of each neighbour as this one has
/// them: beyond the ends of a period, too, they are where `TwoColourLattice` has room for copies.
struct Level {
  TwoColourLattice lattice;                                  ///< the lattice
  RowShare share;                                            ///< of its rows
  int numbers = 0;                                           ///< stored of the matrix at each site
  std::vector<float> matrix;                                 ///< these numbers
  std::array<std::array<std::array<Terms, 2>, 2>, 4> terms;  ///< by row modulo 4, part and colour
  std::vector<float> r, x;                                   ///< right side, solution
  std::vector<float> rest;                                   ///< right side less matrix times solution
  std::vector<float> rows;                            ///< of this lattice as the coarse one: sites in order
  std::array<std::array<PartParents, 2>, 4> parents;  ///< by row modulo 4 and part
  std::array<std::array<std::ptrdiff_t, 9>, 2>
      children;                ///< by part: itself, four of weight 1/2, four of 1/4
  std::vector<RimWeight> rim;  ///< between this lattice and the next one

  /// With the entries of a matrix by sites, times a factor.
  /// @param rows  that are shared
  template <class Matrix>
  void take(Matrix const& m, double factor, RowShare const& rows);
  /// The row of a place in a field of two numbers a site.
  static int row_of(TwoColourLattice const& lattice, std::ptrdiff_t place) {
    return static_cast<int>(place / (4 * lattice.stride())) - 3;
  }
  /// The rows of this rank.
  RowRange own() const { return share.own(); }
  /// Those of the next lattice that this rank makes from its own.
  static int halved(int row) { return (row + 1) >> 1; }
  RowRange own_of_next() const { return {halved(own().from), halved(own().to)}; }
  /// Makes the way to the next lattice.
  void join(Interpolation const& p);

  /// Puts copies that are beyond the ends of a period where the rows themselves are.
  void settle(std::vector<float>& field) const;

  /// From one row of `rows` to the next of the same colour is twice this.
  std::ptrdiff_t row_stride() const { return 2 * lanes * (lattice.blocks() + 1); }
  /// Where site number k of row J of `rows` is.
  std::ptrdiff_t in_row(int row, int colour, int k) const {
    return ((row + 2) * 2 + colour) * row_stride() + lanes + k;
  }
  std::ptrdiff_t in_row(Diagonals s, int colour) const {
    return in_row(s.row(), colour, (s.column() - (s.row() & 1)) >> 1);
  }

  /// The sweep before the coarse correction, from x = 0, and what it leaves.
  [[gnu::always_inline]] void sweep_from_zero() {
    each_class(
        false, [&](int j, int p) __attribute__((always_inline)) {
          for (int c = 0; c < 2; ++c) {
            Terms const& t = terms[j & 3][p][c];
            relax(j, p, c, t.term.data(), t.term.data() + t.before);
          }
        });
    RowRange const mine = own();
    for (int j = mine.from; j < mine.to; ++j)
      for (int p = 0; p < 2; ++p)
        for (int c = 0; c < 2; ++c) {
          // The equation of a cell held when it was swept.
          Terms const& t = terms[j & 3][p][c];
          float* const out = rest.data() + lattice.part(2, j, p, c);
          in_blocks([&](auto& sum, std::ptrdiff_t a) __attribute__((always_inline)) {
            for (auto& s : sum) s = Floats{};
            subtract(sum, t.term.data() + t.before, t.term.data() + t.count, j, p, c, a);
            put(out + a, sum);
          });
          close(rest, j, p, c);
        }
    copy_rows(rest);
  }
  /// The sweep after it.
  [[gnu::always_inline]] void sweep_back() {
    each_class(
        true, [&](int j, int p) __attribute__((always_inline)) {
          for (int c = 1; c >= 0; --c) {
            Terms const& t = terms[j & 3][p][c];
            relax(j, p, c, t.term.data(), t.term.data() + t.count);
          }
        });
  }
  /// The right side of the next lattice.
  [[gnu::always_inline]] void restrict_to(Level& next) const {
    TwoColourLattice const& l = next.lattice;
    RowRange const made = own_of_next();
    for (int j = made.from; j < made.to; ++j)
      for (int c = 0; c < 2; ++c) {
        int const p = j & 1;
        float const* const from = rest.data() + lattice.part(2, 2 * j, p, c);
        float* const to = next.rows.data() + next.in_row(j, c, 0);
        auto const& child = children[p];
        for (std::ptrdiff_t k = 0; k < 2 * lanes * l.blocks(); k += lanes) {
          Floats const edges = (load(from + child[1] + k) + load(from + child[2] + k)) +
                               (load(from + child[3] + k) + load(from + child[4] + k)),
                       corners = (load(from + child[5] + k) + load(from + child[6] + k)) +
                                 (load(from + child[7] + k) + load(from + child[8] + k));
          store(to + k, load(from + k) + 0.5f * edges + 0.25f * corners);
        }
      }
    for (RimWeight const& w : rim)
      if (w.coarse_row >= made.from && w.coarse_row < made.to) next.rows[w.coarse] += w.weight * rest[w.fine];
    for (int j = made.from; j < made.to; ++j)
      for (int c = 0; c < 2; ++c)
        for (std::ptrdiff_t a = 0; a < lanes * l.blocks(); a += lanes) {
          float const* const from = next.rows.data() + next.in_row(j, c, 0) + 2 * a;
          // Copies: a register has to be aligned, these are not.
          Floats const low = load(from), high = load(from + lanes);
          Floats even, odd;
          part_pairs(low, high, even, odd);
          store(next.r.data() + l.part(2, j, 0, c) + a, even);
          store(next.r.data() + l.part(2, j, 1, c) + a, odd);
        }
    if (next.share.alone()) give_whole(next);
  }
  /// Adds what the next lattice has found.
  [[gnu::always_inline]] void interpolate_from(Level& next) {
    RowRange const mine = own(), above = own_of_next();
    next.put_in_rows(next.share.alone() ? next.own() : RowRange{above.from - 1, above.to + 1});
    for (int j = mine.from; j < mine.to; ++j)
      for (int p = 0; p < 2; ++p)
        for (int c = 0; c < 2; ++c) {
          PartParents const& parent = parents[j & 3][p];
          float const* const from = next.rows.data() + next.in_row(j >> 1, c, 0);
          float* const to = x.data() + lattice.part(2, j, p, c);
          float const weight = 1.0f / static_cast<float>(parent.count);
          for (std::ptrdiff_t a = 0; a < lanes * lattice.blocks(); a += lanes) {
            Floats sum = load(from + parent.place[0] + a);
            for (int n = 1; n < parent.count; ++n) sum += load(from + parent.place[n] + a);
            store(to + a, load(to + a) + weight * sum);
          }
        }
    for (RimWeight const& w : rim)
      if (w.fine_row >= mine.from && w.fine_row < mine.to) x[w.fine] += w.weight * next.rows[w.coarse];
    for (int j = mine.from; j < mine.to; ++j)
      for (int p = 0; p < 2; ++p)
        for (int c = 0; c < 2; ++c) close(x, j, p, c);
    copy_rows(x);
  }

 private:
  /// Calls f(part of a loop's sums, first place) until all sites of a part are done.
  template <class F>
  [[gnu::always_inline]] void in_blocks(F const& f) const {
    std::ptrdiff_t a = 0;
    for (; a + 4 * lanes <= lanes * lattice.blocks(); a += 4 * lanes) {
      Floats four[4];
      f(four, a);
    }
    for (; a < lanes * lattice.blocks(); a += lanes) {
      Floats one[1];
      f(one, a);
    }
  }
  template <std::size_t n>
  [[gnu::always_inline]] static void put(float* to, Floats const (&x)[n]) {
    for (std::size_t b = 0; b < n; ++b) store(to + lanes * static_cast<std::ptrdiff_t>(b), x[b]);
  }
  /// Subtracts terms of the matrix times x.
  template <std::size_t n>
  [[gnu::always_inline]] void subtract(Floats (&sum)[n], Term const* t, Term const* end, int j, int p, int c,
                                       std::ptrdiff_t a) const {
    float const* const m = matrix.data() + lattice.part(numbers, j, p, 0) + a;
    float const* const y = x.data() + lattice.part(2, j, p, c) + a;
    for (; t != end; ++t)
      for (std::size_t b = 0; b < n; ++b)
        sum[b] -= load(m + t->coefficient + lanes * static_cast<std::ptrdiff_t>(b)) *
                  load(y + t->number + lanes * static_cast<std::ptrdiff_t>(b));
  }
  /// Solves the equations of the cells of a part with these terms.
  [[gnu::always_inline]] void relax(int j, int p, int c, Term const* from, Term const* end) {
    std::ptrdiff_t const here = lattice.part(2, j, p, c);
    float const* const inverse = matrix.data() + lattice.part(numbers, j, p, c);
    in_blocks([&](auto& sum, std::ptrdiff_t a) __attribute__((always_inline)) {
      std::ptrdiff_t b = a;
      for (auto& s : sum) s = load(r.data() + here + b), b += lanes;
      subtract(sum, from, end, j, p, c, a);
      b = a;
      for (auto& s : sum) s *= load(inverse + b), b += lanes;
      put(x.data() + here + a, sum);
    });
    close(x, j, p, c);
  }
  /// Calls f(row, part) for each class of sites in turn, or in the reverse order.
  template <class F>
  [[gnu::always_inline]] void each_class(bool back, F const& f) {
    for (int n = 0; n < 4; ++n) {
      int const number = back ? 3 - n : n, parity = number >> 1, q = number & 1;
      RowRange const mine = own();
      for (int j = mine.from + ((mine.from + parity) & 1); j < mine.to; j += 2)
        f(j, lattice.part_of_class(j, q));
      copy_class(parity, q);
    }
  }
  /// The neighbours' rows of the solution of one class of sites, which they have just swept.
  void copy_class(int parity, int q);
  /// Two rows of both neighbours of a field.
  void copy_rows(std::vector<float>& field) const;
  /// The right side of the next lattice everywhere, where ranks have made parts of it.
  void give_whole(Level& next) const;
  /// Copies what is round the corner of a periodic direction.
  [[gnu::always_inline]] void close(std::vector<float>& field, int j, int p, int c) const {
    if (lattice.periodic[0] || lattice.periodic[1]) close_periodic(field, j, p, c);
  }
  void close_periodic(std::vector<float>& field, int j, int p, int c) const;
  /// The solution with the sites of each row in order, of rows that are there or copies.
  [[gnu::always_inline]] void put_in_rows(RowRange of) {
    if (!lattice.periodic[1]) of = {std::max(of.from, 0), std::min(of.to, lattice.high())};
    for (int j = of.from; j < of.to; ++j)
      for (int c = 0; c < 2; ++c) {
        for (std::ptrdiff_t a = 0; a < lanes * lattice.blocks(); a += lanes) {
          float* const to = rows.data() + in_row(j, c, 0) + 2 * a;
          Floats const even = load(x.data() + lattice.part(2, j, 0, c) + a),
                       odd = load(x.data() + lattice.part(2, j, 1, c) + a);
          Floats first, second;
          join_pairs(even, odd, first, second);
          store(to, first), store(to + lanes, second);
        }
      }
    if (lattice.periodic[0] || lattice.periodic[1]) close_rows(of);
  }
  void close_rows(RowRange const& of);
};

}  // namespace actio::media::detail
