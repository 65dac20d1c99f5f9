// Boxes of cells in a mesh of space-time, and sums over their boundary.
#pragma once

#include "actio/multisymplectic/discrete_field_equations.hpp"

namespace actio::media {

/// A box of space-time cells: slabs \f$k, \dots, k + s - 1\f$ and in each direction i the cells
/// \f$c_i, \dots, c_i + m_i - 1\f$, counted around where the mesh is periodic.
template <int n>
struct CellBox {
  int first_slab;           ///< k
  int slabs;                ///< s, at least 1
  GridIndex<n> first_cell;  ///< \f$c_i\f$
  GridIndex<n> cells;       ///< \f$m_i\f$, at least 1 and at most as many as the mesh has
};

/// Refuses a box that does not lie in the mesh, or reaches beyond the levels of a section.
/// @throws NotAMesh
template <class S, int n, int N>
void require_box(SpaceTimeMesh<S, n> const& mesh, DiscreteSection<S, n, N> const& section,
                 CellBox<n> const& box) {
  require_section(mesh, section);
  int const last_level = section.last();
  if (box.slabs < 1 || box.first_slab < 0 || box.first_slab > last_level - box.slabs)
    throw NotAMesh("box of space-time", "its slabs lie between levels of the section; last level",
                   box.first_slab + box.slabs, last_level);
  for (int i = 0; i < n; ++i) {
    int const last = box.first_cell[i] + (mesh.periodic(i) ? 0 : box.cells[i]);
    if (box.cells[i] < 1 || box.cells[i] > mesh.cells()[i] || box.first_cell[i] < 0 || last > mesh.cells()[i])
      throw NotAMesh("box of space-time, direction " + std::to_string(i + 1),
                     "its cells lie in the mesh; last cell", last, mesh.cells()[i]);
  }
}

/// Whether a cell of the body lies in a box.
template <class S, int n>
bool in_box(SpaceTimeMesh<S, n> const& mesh, CellBox<n> const& box, GridIndex<n> const& cell) {
  for (int i = 0; i < n; ++i)
    if ((cell[i] - box.first_cell[i] + mesh.cells()[i]) % mesh.cells()[i] >= box.cells[i]) return false;
  return true;
}

/// Whether a node is inside a box: every space-time cell that meets there belongs to the box, and the node is
/// varied in every direction. All others are nodes of the boundary of the box.
template <class S, int n>
bool inside_box(SpaceTimeMesh<S, n> const& mesh, CellBox<n> const& box, int level, Index node) {
  if (level <= box.first_slab || level >= box.first_slab + box.slabs || mesh.fixed(node) ||
      mesh.held_across(node) != 0)
    return false;
  bool all = true;
  mesh.for_cells_at(node, [&](GridIndex<n> const& cell, int) { all = all && in_box(mesh, box, cell); });
  return all;
}

/// The sum over the boundary of a box: over its boundary nodes, and at each of them over the cells of the box
/// that meet there.
/// @param f  a callable (slab, cell, l): what node l of that cell contributes, a number
/// @return   the sum and the magnitudes of its terms
template <class S, int n, class F>
SumOfTerms<S, S> boundary_sum(SpaceTimeMesh<S, n> const& mesh, CellBox<n> const& box, F const& f) {
  SumOfTerms<S, S> total{S(0)};
  for (int slab = box.first_slab; slab < box.first_slab + box.slabs; ++slab)
    mesh.for_cells([&](GridIndex<n> const& cell) {
      if (!in_box(mesh, box, cell)) return;
      for (int b = 0; b < mesh.corners; ++b)
        for (int level = 0; level < 2; ++level)
          if (!inside_box(mesh, box, slab + level, mesh.node(cell, b)))
            total.add(f(slab, cell, node_of_corner<n>(b, level)));
    });
  return total;
}

}  // namespace actio::media
