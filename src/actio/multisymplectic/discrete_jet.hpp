// Discrete jets: the first jet of a discrete section at a corner of a space-time cell (chapter 10 of the
// thesis).
//
// A discrete section has values at the nodes of a mesh. A space-time cell has 2^(n+1) nodes; node l of it is
// corner b of the cell of the body at the earlier level, l = b, or at the later one, l = b + 2^n. The jet at
// a node is made of the differences along the n + 1 edges that meet there: two nodes of a cell whose numbers
// differ in one bit are neighbours, and the jet at a node contains the node and its neighbours.
#pragma once

#include "actio/meshes/cell_geometry.hpp"

namespace actio::media {

/// A space-time cell with the values of a discrete section at its nodes.
/// @tparam S  scalar of the values; shape and times are plain numbers
template <class S, int n, int N>
struct SpaceTimeCell {
  static constexpr int corners = corners_of_cell<n>;  ///< of the cell of the body
  static constexpr int nodes = 2 * corners;           ///< corners at both levels

  CellGeometry<Base<S>, n> const* geometry;  ///< shape of the cell of the body
  std::array<Base<S>, 2> time;               ///< earlier and later level
  Matrix<S, N, nodes> y;                     ///< values \f$y_l\f$, a column for each node

  /// Duration of the slab.
  Base<S> duration() const { return time[1] - time[0]; }
  /// The part of the volume \f$d^{n+1}x\f$ that a node stands for.
  Base<S> volume(int l) const { return duration() / Base<S>(2) * geometry->volume[l % corners]; }
  /// The same cell with other values, of as many components as these have.
  template <class T, int M>
  SpaceTimeCell<T, n, M> with(Matrix<T, M, nodes> const& values) const { return {geometry, time, values}; }
  /// The same cell over a scalar that extends S.
  template <class T>
  SpaceTimeCell<T, n, N> cast() const { return with(Matrix<T, N, nodes>(y.template cast<T>())); }
};

/// The node at a corner of the cell of the body, at the earlier (0) or the later level (1).
template <int n>
constexpr int node_of_corner(int corner, int level) { return corner + level * corners_of_cell<n>; }

/// Whether the discrete jet at node l contains the value at node m: they are the same, or the ends of an edge
/// of space-time; of a cell with a correction all nodes at a level.
template <class S, int n, int N>
bool jet_contains(SpaceTimeCell<S, n, N> const& cell, int l, int m) {
  return std::popcount(unsigned(l ^ m)) <= 1 ||
         (cell.geometry->correction.any && l / cell.corners == m / cell.corners);
}

/// The discrete jet at a node of a space-time cell: the event and the value there, the velocity
/// \f$v_0 = (y_{b,1} - y_{b,0})/(t_1 - t_0)\f$, and the deformation gradient F that takes the edges of the
/// reference cell at this corner to their images, \f$F\,(X_{b^i} - X_b) = y_{b^i} - y_b\f$, with what the
/// \ref CornerCorrection of the cell adds to it.
///
/// @param l  node of the cell, its corner b at one of the two levels
/// Accuracy: the jet of a section at the centre of the edge in time and at the corner of those in space, to
/// first order in the size of the cell; exact for sections that are affine in the cell.
template <class S, int n, int N>
Jet<S, n, N> discrete_jet(SpaceTimeCell<S, n, N> const& cell, int l) {
  int const b = l % cell.corners, level = l / cell.corners;
  auto const at_level = cell.y.template middleCols<corners_of_cell<n>>(level * cell.corners);
  auto F = edges_at_corner<n>(at_level, b) * cell.geometry->inverse_edges[b];
  if (cell.geometry->correction.any)
    F += cell.geometry->correction.template common<S, N>([&](int c, int a) { return at_level(a, c); });
  Base<S> const rate = Base<S>(1) / cell.duration();
  Jet<S, n, N> j;
  j.x[0] = S(cell.time[level]);
  for (int i = 0; i < n; ++i) j.x[1 + i] = S(cell.geometry->places(i, b));
  int const before = node_of_corner<n>(b, 0), after = node_of_corner<n>(b, 1);
  // [discrete_jet]
  for (int a = 0; a < N; ++a) {
    j.y[a] = cell.y(a, l);
    j.v(a, 0) = (cell.y(a, after) - cell.y(a, before)) * rate;
    for (int i = 0; i < n; ++i) j.v(a, 1 + i) = F(a, i);
  }
  // [discrete_jet]
  return j;
}

}  // namespace actio::media
