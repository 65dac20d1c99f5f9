// Structured meshes of space-time: a box of cells of the body times slabs of time (chapter 10 of the thesis).
//
// The body is a box of c_1 x ... x c_n cells in a coordinate cube, mapped to points of the body by a
// callable; time runs through levels t_0 < t_1 < ..., a slab between two of them. A space-time cell is a cell
// of the body times a slab, and has 2^(n+1) nodes: the corners of the cell at both levels. Opposite sides of
// the box may be one and the same (periodic); other sides are free, or fixed, or such that the section
// slides along them. Unstructured meshes of simplices are stepped in asynchronous_steps.hpp.
#pragma once

#include <algorithm>
#include <limits>
#include <vector>

#include "actio/meshes/cell_geometry.hpp"
#include "actio/meshes/side.hpp"

namespace actio::media {

/// The sides of a box: for each direction the near and the far one, `{{{Side::fixed, Side::free}}}` on a
/// line. \ref all_sides makes them alike.
template <int n>
using Sides = std::array<std::array<Side, 2>, n>;

/// The same at every side.
template <int n>
Sides<n> all_sides(Side side) {
  Sides<n> sides;
  for (auto& pair : sides) pair = {side, side};
  return sides;
}

/// Numbers along the n directions of a box: of a cell, of a node, or how many there are.
template <int n>
struct GridIndex : std::array<int, n> {};

/// A mesh that does not exist as described: without cells, with levels that do not increase, with sides that
/// do not fit.
struct NotAMesh : OutsideDomain {
  using OutsideDomain::OutsideDomain;
};

/// A box \f$[low, high]\f$ of the body with edges along the coordinates, for \ref SpaceTimeMesh.
template <class S, int n>
struct StraightBox {
  Matrix<S, n, 1> low;   ///< its near corner
  Matrix<S, n, 1> high;  ///< its far corner
  /// The point of the body with coordinates u in the unit cube.
  Matrix<S, n, 1> operator()(Matrix<S, n, 1> const& u) const {
    Matrix<S, n, 1> x;
    for (int i = 0; i < n; ++i) x[i] = low[i] * (S(1) - u[i]) + high[i] * u[i];
    return x;
  }
};

/// A structured mesh of space-time.
///
/// \snippet ch10_outlook/try_it.cpp step_of_a_section
template <class S, int n>
class SpaceTimeMesh {
 public:
  static constexpr int corners = corners_of_cell<n>;  ///< of a cell of the body

  /// @param times  levels, increasing: any number of them, and steps that may differ
  /// @param cells  how many cells in each direction; at least two in a periodic one
  /// @param sides  near and far side in each direction
  /// @param shape  points of the body: a callable on the unit cube, orientation preserving
  /// @throws NotAMesh      where there are no cells, or too many to count, where levels do not increase, and
  ///         where periodic sides are not translated copies of each other
  /// @throws InvertedCell  where a cell is flat or turned inside out
  template <class Shape>
  SpaceTimeMesh(std::vector<S> times, GridIndex<n> const& cells, Sides<n> const& sides, Shape const& shape)
      : times_(std::move(times)), cells_(cells), sides_(sides) {
    require_grid();
    for (int i = 0; i < n; ++i) nodes_[i] = cells_[i] + (periodic(i) ? 0 : 1);
    make_geometry(shape);
  }

  /// How many levels of time there are.
  int levels() const { return static_cast<int>(times_.size()); }
  /// The time of a level.
  S const& time(int level) const { return times_[level]; }
  /// How many cells of the body there are in each direction.
  GridIndex<n> const& cells() const { return cells_; }
  /// How many nodes there are in each direction.
  GridIndex<n> const& nodes() const { return nodes_; }
  /// How many cells of the body there are.
  Index cell_count() const { return product(cells_); }
  /// How many nodes a level has.
  Index node_count() const { return product(nodes_); }
  /// Whether the two sides in a direction are one.
  bool periodic(int i) const { return sides_[i][0] == Side::periodic; }

  /// The number of a cell of the body, in the order of \ref for_cells.
  Index number(GridIndex<n> const& cell) const { return position(cell, cells_); }
  /// The reference shape of a cell.
  CellGeometry<S, n> const& geometry(GridIndex<n> const& cell) const { return geometry_[number(cell)]; }
  /// The node at a corner of a cell.
  Index node(GridIndex<n> const& cell, int corner) const {
    GridIndex<n> index;
    for (int i = 0; i < n; ++i) index[i] = (cell[i] + end_of(corner, i)) % nodes_[i];
    return position(index, nodes_);
  }
  /// Whether a corner of a cell lies beyond the seam in direction i, where a periodic box begins again.
  bool beyond_seam(GridIndex<n> const& cell, int corner, int i) const {
    return cell[i] + end_of(corner, i) == nodes_[i];
  }
  /// The point of the body at a node.
  Matrix<S, n, 1> place(Index node) const {
    Matrix<S, n, 1> x = Matrix<S, n, 1>::Zero();
    bool found = false;
    for_cells_at(node, [&](GridIndex<n> const& cell, int corner) {
      // Of the two copies of a node on a seam, the near one.
      bool near = true;
      for (int i = 0; i < n; ++i) near = near && !beyond_seam(cell, corner, i);
      if (!near || found) return;
      x = geometry(cell).places.col(corner);
      found = true;
    });
    return x;
  }
  /// The event at a node: its time, then its point of the body.
  Event<S, n> event(int level, Index node) const {
    Event<S, n> x;
    x << times_[level], place(node);
    return x;
  }
  /// Whether a node lies on a fixed side.
  bool fixed(Index node) const {
    auto const index = grid_index(node, nodes_);
    for (int i = 0; i < n; ++i)
      if ((index[i] == 0 && sides_[i][0] == Side::fixed) ||
          (index[i] + 1 == nodes_[i] && sides_[i][1] == Side::fixed))
        return true;
    return false;
  }

  /// Which components of the value at a node the sliding sides through it hold: bit i for component i.
  unsigned held_across(Index node) const {
    auto const index = grid_index(node, nodes_);
    unsigned held = 0;
    for (int i = 0; i < n; ++i)
      if ((index[i] == 0 && sides_[i][0] == Side::sliding) ||
          (index[i] + 1 == nodes_[i] && sides_[i][1] == Side::sliding))
        held |= 1u << i;
    return held;
  }

  /// Calls f(cell, corner) for every cell of the body that meets at a node, the node being that corner of it.
  template <class F>
  void for_cells_at(Index node, F const& f) const {
    auto const index = grid_index(node, nodes_);
    for (int corner = 0; corner < corners; ++corner) {
      GridIndex<n> cell;
      bool exists = true;
      for (int i = 0; i < n; ++i) {
        cell[i] = index[i] - end_of(corner, i);
        if (periodic(i)) cell[i] = (cell[i] + cells_[i]) % cells_[i];
        exists = exists && cell[i] >= 0 && cell[i] < cells_[i];
      }
      if (exists) f(cell, corner);
    }
  }
  /// Calls f(cell) for every cell of the body.
  template <class F>
  void for_cells(F const& f) const {
    for (Index k = 0; k < cell_count(); ++k) f(grid_index(k, cells_));
  }

 private:
  std::vector<S> times_;
  GridIndex<n> cells_, nodes_;
  Sides<n> sides_;
  std::vector<CellGeometry<S, n>> geometry_;

  static int end_of(int corner, int i) { return (corner >> i) & 1; }
  static Index product(GridIndex<n> const& counts) {
    Index all = 1;
    for (int count : counts) all *= count;
    return all;
  }
  static Index position(GridIndex<n> const& index, GridIndex<n> const& counts) {
    Index k = 0;
    for (int i = n - 1; i >= 0; --i) k = k * counts[i] + index[i];
    return k;
  }
  static GridIndex<n> grid_index(Index k, GridIndex<n> const& counts) {
    GridIndex<n> index;
    for (int i = 0; i < n; ++i) {
      index[i] = static_cast<int>(k % counts[i]);
      k /= counts[i];
    }
    return index;
  }

  void require_grid() const {
    if (times_.empty()) throw NotAMesh("space-time mesh", "time has a first level; levels", 0, 1);
    for (int k = 0; k + 1 < levels(); ++k)
      if (ordered_arithmetic<S>() && !(times_[k + 1] > times_[k]))
        throw NotAMesh("space-time mesh, level " + std::to_string(k + 1), "times increase; time",
                       to_double(times_[k + 1]), to_double(times_[k]));
    double all = 1;
    for (int i = 0; i < n; ++i) {
      auto const where = "space-time mesh, direction " + std::to_string(i + 1);
      if ((sides_[i][0] == Side::periodic) != (sides_[i][1] == Side::periodic))
        throw NotAMesh(where, "a periodic side is the same as the opposite one; periodic sides", 1, 2);
      if (sides_[i][0] == Side::moved || sides_[i][1] == Side::moved)
        throw NotAMesh(where, "no side of a box is moved; moved sides", 1, 0);
      int const least = periodic(i) ? 2 : 1;
      if (cells_[i] < least) throw NotAMesh(where, "there are cells enough; cells", cells_[i], least);
      all *= cells_[i] + 1.0;
    }
    double const most = double(std::numeric_limits<Index>::max() / 4);
    if (all > most) throw NotAMesh("space-time mesh", "the nodes can be counted; nodes", all, most);
  }

  template <class Shape>
  void make_geometry(Shape const& shape) {
    auto const point = [&](GridIndex<n> const& cell, int corner) {
      Matrix<S, n, 1> u;
      for (int i = 0; i < n; ++i) u[i] = S(S(cell[i] + end_of(corner, i)) / S(cells_[i]));
      Matrix<S, n, 1> const x = shape(u);
      require_finite(x, "shape of a space-time mesh");
      return x;
    };
    geometry_.reserve(static_cast<std::size_t>(cell_count()));
    for_cells([&](GridIndex<n> const& cell) {
      Matrix<S, n, corners> places;
      for (int b = 0; b < corners; ++b) places.col(b) = point(cell, b);
      std::string name = "(";
      for (int i = 0; i < n; ++i) name += (i ? ", " : "") + std::to_string(cell[i]);
      geometry_.push_back(cell_geometry<S, n>(places, name + ")"));
    });
    for (int i = 0; i < n; ++i)
      if (periodic(i)) require_seam(i);
  }

  // The edges within a seam are the same seen from either side of the box.
  void require_seam(int i) const {
    for_cells([&](GridIndex<n> const& near) {
      if (near[i] != 0) return;
      auto far = near;
      far[i] = cells_[i] - 1;
      auto const &a = geometry(near).places, &b = geometry(far).places;
      for (int corner = 0; corner < corners; ++corner) {
        if (end_of(corner, i) == 1) continue;
        int const opposite = corner | (1 << i);
        Matrix<S, n, 1> const gap = (b.col(opposite) - a.col(corner)) - (b.col(1 << i) - a.col(0));
        // Six differences and sums of coordinates, each rounded by the map as well.
        S const bound = S(64) * epsilon<S>() * std::max(magnitude(a), magnitude(b));
        if (ordered_arithmetic<S>() && magnitude(gap) > bound)
          throw NotAMesh("space-time mesh at x = " + show(a.col(corner)),
                         "periodic sides are translated copies of each other; gap", to_double(magnitude(gap)),
                         to_double(bound));
      }
    });
  }
};

/// Levels \f$t_k = t_0 + kh\f$ of time: `steps` slabs of the same length.
template <class S>
std::vector<S> equal_steps(S const& start, S const& step, int steps) {
  std::vector<S> times;
  for (int k = 0; k <= steps; ++k) times.push_back(S(start + step * S(k)));
  return times;
}

}  // namespace actio::media
