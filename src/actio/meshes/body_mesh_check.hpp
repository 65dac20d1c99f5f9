// Whether a mesh is one of a body: cells that are not inverted, flat or doubled, in one piece, with sides
// that are theirs.
#pragma once

#include <algorithm>
#include <cmath>
#include <numeric>

#include "actio/meshes/body_mesh.hpp"

namespace actio::media {

/// The Jacobian of the reference map at a corner of a cell: the determinant of the edges that meet there,
/// counted as running along 0, 1, 2, for a simplex of those from corner 0.
struct CornerJacobian {
  double volume;  ///< with sign, length^dimension
  double box;     ///< the product of the lengths of the edges
};
/// \ref CornerJacobian of a corner. A simplex has one, at corner 0.
CornerJacobian corner_jacobian(BodyMesh const& mesh, int cell, int corner);

namespace detail {

/// A cell and its nodes, for messages.
inline std::string cell_name(BodyMesh const& mesh, int cell) {
  std::string name = "mesh of a body, " + mesh.cell_name(cell) + " with nodes";
  for (int b = 0; b < corner_count(mesh.shape); ++b) name += " " + mesh.node_name(mesh.cells[cell][b]);
  return name;
}
/// A place, for messages.
inline std::string place_name(std::array<double, 3> const& x) {
  return "(" + show(x[0]) + ", " + show(x[1]) + ", " + show(x[2]) + ")";
}

/// A facet with its nodes in increasing order, its cell, and from which side the cell looks at it.
struct SortedFacet {
  std::array<int, 4> nodes;
  int cell;
  bool turned;  ///< of two cells on both sides of a facet one has it turned
};
/// Whether the nodes of a facet go round the other way than from the least one to its lesser neighbour; of a
/// point, whether it is the upper end.
bool is_turned(std::array<int, 4> const& nodes, int facet);

}  // namespace detail

/// Refuses a mesh that is none: cells that are inverted, degenerate, doubled or unconnected, corners or nodes
/// that are missing, sides with facets that are none of a cell.
///
/// @throws NotABodyMesh  with the cell, its corner and the measured number; NotFinite where a place is none
/// Its work is that of sorting all facets.
void require_body_mesh(BodyMesh const& mesh);

}  // namespace actio::media
