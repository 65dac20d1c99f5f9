// From a lattice of the multigrid solver to the next one: interpolation, and the matrix P^T A P.
//
// Values between the sites of the coarse lattice are bilinear in u and v, for each colour by itself. At the
// rim some of the sites are missing. Beyond a free side, where the pressure vanishes, they count as zero. A
// wall reflects: cell (-1-i, j), the mirror image of (i, j), has the other colour, so the share of what is
// missing goes to the values of the other colour at the same sites.
#pragma once

#include <vector>

#include "actio/incompressible_media/nine_point_matrix.hpp"
#include "actio/incompressible_media/two_colour_lattice.hpp"

namespace actio::media::detail {

/// Walls of a box: left, right, below, above.
using Walls = std::array<bool, 4>;

/// The entries of the cells of a site with those of the nine sites around it.
struct SiteEntries {
  double entry[2][2][3][3] = {};  ///< from colour, to colour, u + 1, v + 1
};

/// The matrix of a coarse lattice while the hierarchy is made.
struct CoarseMatrix {
  TwoColourLattice lattice;        ///< whose cells it couples
  std::vector<SiteEntries> sites;  ///< row by row

  explicit CoarseMatrix(TwoColourLattice const& l)
      : lattice(l), sites(static_cast<std::size_t>(l.high() * l.sites())) {}
  /// Of a site within the lattice.
  SiteEntries& at(Diagonals s) {
    return sites[static_cast<std::size_t>(s.row() * lattice.sites() + (s.column() >> 1))];
  }
  SiteEntries const& at(Diagonals s) const { return const_cast<CoarseMatrix*>(this)->at(s); }
  /// The diagonal entry of a cell.
  double self(Diagonals s, int c) const { return at(s).entry[c][c][1][1]; }
  /// Calls f(d, du, dv, a) for the entries a of a cell of colour c, the diagonal apart.
  template <class F>
  void each_entry(Diagonals s, int c, F const& f) const {
    SiteEntries const& e = at(s);
    for (int d = 0; d < 2; ++d)
      for (int x = 0; x < 3; ++x)
        for (int y = 0; y < 3; ++y)
          if (d != c || x != 1 || y != 1) f(d, x - 1, y - 1, e.entry[c][d][x][y]);
  }
};

/// The matrix of the cells, by sites.
struct CellMatrix {
  NinePointMatrix const& matrix;       ///< as it is given
  std::size_t pinned = matrix.size();  ///< number of a cell whose pressure is pinned, if there is one
  double pin = 0;                      ///< what that adds to its diagonal, and does not count here
  /// Of the sites.
  TwoColourLattice lattice = TwoColourLattice::of_cells(matrix.cells, matrix.periodic);

  explicit CellMatrix(NinePointMatrix const& m) : matrix(m) {}
  /// Where cell number k is in a field of the lattice.
  std::ptrdiff_t place(std::size_t k) const {
    auto const n = static_cast<std::size_t>(matrix.cells[0]);
    int const i = static_cast<int>(k % n), j = static_cast<int>(k / n), c = (i + j) & 1;
    return lattice.at(2, lattice.wrapped(Diagonals::of(i, j - c)), c);
  }
  /// \copydoc CoarseMatrix::self
  double self(Diagonals s, int c) const {
    std::size_t const k = matrix.at(s.column(), s.row() + c);
    return matrix.self[k] - (k == pinned ? pin : 0);
  }
  /// \copydoc CoarseMatrix::each_entry
  template <class F>
  void each_entry(Diagonals s, int c, F const& f) const {
    int const i = s.column(), j = s.row() + c;
    auto const give = [&](double a, int x, int y, int colour) {
      auto const n = Diagonals::of(i + x, j + y - colour);
      f(colour, n.u - s.u, n.v - s.v, a);
    };
    if (i > 0 && i + 1 < matrix.cells[0] && j > 0 && j + 1 < matrix.cells[1]) {
      std::size_t const k = matrix.at(i, j), row = static_cast<std::size_t>(matrix.cells[0]);
      give(matrix.east[k], 1, 0, 1 - c), give(matrix.east[k - 1], -1, 0, 1 - c);
      give(matrix.north[k], 0, 1, 1 - c), give(matrix.north[k - row], 0, -1, 1 - c);
      give(matrix.north_east[k], 1, 1, c), give(matrix.north_east[k - row - 1], -1, -1, c);
      give(matrix.north_west[k], -1, 1, c), give(matrix.north_west[k - row + 1], 1, -1, c);
    } else
      matrix.each_neighbour(i, j, [&](double a, int i1, int j1) { give(a, i1 - i, j1 - j, (i1 + j1) & 1); });
  }
};

/// The sites from which a coordinate is interpolated, with their weights.
struct Parents {
  int first, count;  ///< along the coarse coordinate: the first one, and one or two
  double weight;     ///< of each
  explicit Parents(int u) : first(u >> 1), count(1 + (u & 1)), weight(u & 1 ? 0.5 : 1.0) {}
};

/// What a cell takes of the bilinear values of its own colour and of the other one: 1 and 0 but at the rim.
struct Shares {
  double own = 1, other = 0;  ///< times the bilinear value of this colour, of the other one
  /// Whether all that the cell is interpolated from is behind walls, as in some corners. For the coarse
  /// matrix such a cell has the value of whatever acts on it.
  bool orphan() const { return own == 0 && other == 0; }
};

/// Interpolation from a coarse lattice to a fine one.
struct Interpolation {
  TwoColourLattice fine, coarse;  ///< between which it goes
  Walls walls;                    ///< that reflect; the other sides are free

  Interpolation(TwoColourLattice const& lattice, Walls const& w)
      : fine(lattice), coarse(lattice.coarse()), walls(w) {}
  /// Of a cell.
  Shares of(Diagonals s, int c) const { return at_the_rim(s) ? at_rim(s, c) : Shares{}; }
  /// Calls f(site, weight) for the coarse sites from which a site is interpolated, of those that are not
  /// there as well.
  template <class F>
  static void each_parent(Diagonals s, F const& f) {
    Parents const u(s.u), v(s.v);
    for (int x = 0; x < u.count; ++x)
      for (int y = 0; y < v.count; ++y) f(Diagonals{u.first + x, v.first + y}, u.weight * v.weight);
  }
  /// Whether some of the sites from which this one is interpolated may be missing.
  bool at_the_rim(Diagonals s) const {
    int const i = s.column(), j = s.row();
    return (!fine.periodic[0] && (i < 2 || i >= fine.columns - 2)) ||
           (!fine.periodic[1] && (j < 2 || j >= fine.high() - 3));
  }
  /// Whether that may be so of the sites around it, or whether a period ends there.
  bool near_the_rim(Diagonals s) const {
    int const i = s.column(), j = s.row();
    return i < 4 || i >= fine.columns - 4 || j < 4 || j >= fine.high() - 5;
  }

 private:
  /// The shares of a cell some of whose parents are missing.
  Shares at_rim(Diagonals s, int c) const {
    double own = 0, other = 0, behind_walls = 0, beyond_free_sides = 0;
    each_parent(s, [&](Diagonals p, double w) {
      if (coarse.holds(1 - c, p)) other += w;
      if (coarse.holds(c, p)) return void(own += w);
      bool const left = !coarse.periodic[0] && p.column() < 0,
                 right = !coarse.periodic[0] && p.column() >= coarse.columns,
                 below = !coarse.periodic[1] && p.row() < 0,
                 above = !coarse.periodic[1] && p.row() >= coarse.to[static_cast<std::size_t>(c)];
      bool const zero =
          (left && !walls[0]) || (right && !walls[1]) || (below && !walls[2]) || (above && !walls[3]);
      (zero ? beyond_free_sides : behind_walls) += w;
    });
    if (behind_walls == 0) return {};
    if (other > 0) return {1, behind_walls / other};
    if (own > 0) return {1 + behind_walls / own, 0};
    return {beyond_free_sides > 0 ? 1.0 : 0.0, 0};
  }
};

/// P^T A P.
///
/// Row by row of A: the row of A P first, over the nine sites from which the site and its neighbours are
/// interpolated, then times the column of P^T.
/// @param made  rows of the result that are complete
template <class FineMatrix>
CoarseMatrix coarsened(FineMatrix const& matrix, Interpolation const& p, RowRange const& made) {
  CoarseMatrix out(p.coarse);
  p.fine.each_site({2 * made.from - 2, 2 * made.to + 1}, [&](Diagonals s) {
    Parents const pu(s.u), pv(s.v);
    int const u0 = (s.u - 1) >> 1, v0 = (s.v - 1) >> 1, width = 3 - (s.u & 1), height = 3 - (s.v & 1);
    bool const inside = !p.near_the_rim(s);
    for (int c = 0; c < 2; ++c) {
      if (!p.fine.holds(c, s)) continue;
      double row[2][3][3] = {};
      auto const add = [&](int d, Diagonals n, double a) {
        Shares share = inside ? Shares{} : p.of(n, d);
        if (share.orphan()) n = s, d = c, share = p.of(s, c);
        Interpolation::each_parent(n, [&](Diagonals parent, double w) {
          row[d][parent.u - u0][parent.v - v0] += a * w * share.own;
          if (share.other != 0) row[1 - d][parent.u - u0][parent.v - v0] += a * w * share.other;
        });
      };
      add(c, s, matrix.self(s, c));
      matrix.each_entry(s, c, [&](int d, int du, int dv, double a) {
        if (a != 0) add(d, {s.u + du, s.v + dv}, a);
      });
      Shares const share = inside ? Shares{} : p.of(s, c);
      Interpolation::each_parent(s, [&](Diagonals parent, double w) {
        for (int colour = 0; colour < 2; ++colour) {
          double const mine = w * (colour == c ? share.own : share.other);
          if (mine == 0 || (!inside && !p.coarse.holds(colour, parent))) continue;
          auto& entries = out.at(inside ? parent : p.coarse.wrapped(parent)).entry[colour];
          int const x0 = u0 - parent.u + 1, y0 = v0 - parent.v + 1;
          for (int d = 0; d < 2; ++d)
            for (int x = 0; x < width; ++x)
              for (int y = 0; y < height; ++y) entries[d][x0 + x][y0 + y] += mine * row[d][x][y];
        }
      });
    }
  });
  // What leads to cells that are not there.
  out.lattice.each_site(made, [&](Diagonals s) {
    for (int d = 0; d < 2; ++d)
      for (int x = 0; x < 3; ++x)
        for (int y = 0; y < 3; ++y)
          if (!out.lattice.holds(d, {s.u + x - 1, s.v + y - 1}))
            for (int c = 0; c < 2; ++c) out.at(s).entry[c][d][x][y] = 0;
  });
  return out;
}

}  // namespace actio::media::detail
