// Meshes of a body: nodes, cells and named sides in its reference space (chapter 10 of the thesis).
//
// A mesh is a list of cells that name their corners. Structured boxes, discs and balls, and meshes from a
// file are all of this kind. Here are the mesh, its facets, and boxes; body_shapes.hpp makes round bodies,
// gmsh_mesh.hpp reads files, body_mesh_check.hpp refuses meshes that are none.
#pragma once

#include <array>
#include <cstddef>
#include <limits>
#include <map>
#include <string>
#include <vector>

#include "actio/numbers/errors.hpp"

namespace actio::media {

/// A mesh of a body that does not exist as described: without cells, inverted, in pieces, too large to count.
struct NotABodyMesh : OutsideDomain {
  int cell;  ///< the first cell that is wrong, or -1 where that is not a matter of one cell
  /// As \ref OutsideDomain, with the first cell that is wrong.
  NotABodyMesh(std::string const& where, std::string const& required, double measured_value,
               double bound_value, int which_cell = -1)
      : OutsideDomain(where, required, measured_value, bound_value), cell(which_cell) {}
};

/// What a cell of a body is.
enum class CellShape {
  segment,        ///< of a body of one dimension
  triangle,       ///< of two dimensions, with one deformation gradient
  quadrilateral,  ///< of two dimensions, with a deformation gradient at each corner
  tetrahedron,    ///< of three dimensions, with one deformation gradient
  hexahedron      ///< of three dimensions, with a deformation gradient at each corner
};

/// Cells of a body in its reference space.
struct BodyMesh {
  /// What all cells are.
  using Shape = CellShape;

  int dimension = 2;                         ///< of the body: 1, 2 or 3
  Shape shape = Shape::quadrilateral;        ///< of every cell
  std::vector<std::array<double, 3>> nodes;  ///< reference places X, Y, Z, length; zero beyond the dimension
  /// The nodes at the corners of each cell. Of box-like cells bit k of a corner's number says "upper along
  /// k"; simplices use the first dimension + 1. A cell is oriented as the body: its edges along 0, 1, 2, or
  /// from corner 0 to the others, have a positive determinant.
  std::vector<std::array<int, 8>> cells;
  /// Empty, or for each corner of each cell: bit k says that it lies one period along k beyond its node.
  std::vector<std::array<unsigned char, 8>> wraps;
  std::array<double, 3> periods = {0, 0, 0};  ///< of the box along each direction; zero where it has none
  /// Facets by the name of their side (left, right, bottom, top, front, back; inner, outer; the physical
  /// names of a file): their nodes as `facet_nodes` gives them, with -1 in places that are not used.
  std::map<std::string, std::vector<std::array<int, 4>>> sides;
  /// Groups of facets in a file of which some lie inside of the body, between two cells: what is held or
  /// moved there is made a side. A facet looks to the side to which it looks in the file.
  std::map<std::string, std::vector<std::array<int, 4>>> inside;
  std::map<std::string, std::string> no_sides;  ///< groups of facets that belong to no cell, and where
  std::array<int, 3> grid = {0, 0, 0};    ///< how many cells a box has along each direction; zero of others
  std::vector<std::size_t> element_tags;  ///< of the cells in the file that they come from; empty of others
  std::vector<int> node_tags;             ///< of the nodes there; empty of others

  /// A cell for messages, as people know it: by its place in a box, "cell (3, 0)", by its tag in a file,
  /// "element 12", and otherwise by its number.
  std::string cell_name(int cell) const;
  /// A node for messages: its tag in a file, or its number.
  std::string node_name(int node) const {
    return std::to_string(node < int(node_tags.size()) && node >= 0 ? node_tags[node] : node);
  }

  /// Memory that nodes, cells, wraps and tags take, bytes.
  std::size_t bytes() const {
    return nodes.size() * sizeof(nodes[0]) + cells.size() * sizeof(cells[0]) +
           wraps.size() * sizeof(wraps[0]) + element_tags.size() * sizeof(element_tags[0]) +
           node_tags.size() * sizeof(node_tags[0]);
  }
};

/// A facet of a cell of a mesh.
struct CellFacet {
  int cell;   ///< which cell
  int facet;  ///< which of its facets
};

/// The name of a shape.
inline char const* name_of(BodyMesh::Shape shape) {
  static constexpr char const* names[] = {"segment", "triangle", "quadrilateral", "tetrahedron",
                                          "hexahedron"};
  return names[static_cast<int>(shape)];
}
/// Whether cells are simplices; if not they are box-like. A segment is both, and counts as box-like.
inline bool is_simplex(BodyMesh::Shape shape) {
  return shape == BodyMesh::Shape::triangle || shape == BodyMesh::Shape::tetrahedron;
}
/// How many corners a cell has.
inline int corner_count(BodyMesh::Shape shape) {
  static constexpr int counts[] = {2, 3, 4, 4, 8};
  return counts[static_cast<int>(shape)];
}
/// How many facets a cell has. Of box-like cells facet 2 k + end is the lower or the upper one across k; of
/// simplices facet k lies opposite corner k.
inline int facet_count(BodyMesh::Shape shape) {
  static constexpr int counts[] = {2, 3, 4, 4, 6};
  return counts[static_cast<int>(shape)];
}
/// The corners of a facet, -1 in places that are not used. They run so that the facet looks outwards: in the
/// plane with the body at the left of the way from the first to the second, in space counterclockwise for who
/// looks at the body from outside.
std::array<int, 4> const& facet_corners(BodyMesh::Shape shape, int facet);
/// The nodes of a facet, in the order of \ref facet_corners; -1 in places that are not used.
std::array<int, 4> facet_nodes(BodyMesh const& mesh, CellFacet const& at);
/// The place of a corner of a cell, with its period where the cell lies across a seam.
std::array<double, 3> corner_place(BodyMesh const& mesh, int cell, int corner);

/// The facets of a side with the cells that they belong to, in the order of the side: what a load on the side
/// needs where the body is periodic, because a facet across a seam has its places from its cell.
/// @throws NotABodyMesh  where there is no such side, or a facet of it belongs to no cell
std::vector<CellFacet> facets_of_side(BodyMesh const& mesh, std::string const& side);

namespace detail {

/// The names of the sides of a box.
inline constexpr char const* side_names[3][2] = {{"left", "right"}, {"bottom", "top"}, {"front", "back"}};

/// A grid of box-like cells: node (i, j, k) is number i + n_0 (j + n_1 k), and cells count in the same way.
struct CellGrid {
  int dimension;                                       ///< 1, 2 or 3
  std::array<int, 3> cells;                            ///< along each direction; 1 beyond the dimension
  std::array<bool, 3> around = {false, false, false};  ///< whether the last nodes are the first ones

  /// How many nodes there are along a direction.
  int nodes(int k) const { return k >= dimension ? 1 : cells[k] + !around[k]; }
  /// The number of a node whose place in the grid may lie one period beyond.
  int node(std::array<int, 3> at) const {
    for (int k = 0; k < dimension; ++k) at[k] %= nodes(k);
    return at[0] + nodes(0) * (at[1] + nodes(1) * at[2]);
  }
  /// The place in the grid of a cell with this number.
  std::array<int, 3> cell(int number) const {
    return {number % cells[0], number / cells[0] % cells[1], number / cells[0] / cells[1]};
  }

  /// @throws NotABodyMesh  where there are no cells, or more nodes than numbers for them
  void examine() const;
  /// The mesh of these cells, with the sides of a box.
  /// @param place  of a node, given its place in the grid
  template <class Place>
  BodyMesh mesh(Place const& place) const {
    examine();
    static constexpr BodyMesh::Shape shapes[] = {BodyMesh::Shape::segment, BodyMesh::Shape::quadrilateral,
                                                 BodyMesh::Shape::hexahedron};
    BodyMesh mesh;
    mesh.dimension = dimension;
    mesh.shape = shapes[dimension - 1];
    mesh.nodes.reserve(std::size_t(nodes(0)) * nodes(1) * nodes(2));
    for (int k = 0; k < nodes(2); ++k)
      for (int j = 0; j < nodes(1); ++j)
        for (int i = 0; i < nodes(0); ++i) mesh.nodes.push_back(place(std::array<int, 3>{i, j, k}));
    int const count = cells[0] * cells[1] * cells[2];
    mesh.cells.reserve(count);
    for (int c = 0; c < count; ++c) {
      std::array<int, 8> corners{};
      for (int b = 0; b < 1 << dimension; ++b) {
        auto at = cell(c);
        for (int k = 0; k < dimension; ++k) at[k] += b >> k & 1;
        corners[b] = node(at);
      }
      mesh.cells.push_back(corners);
      for (int k = 0; k < dimension; ++k)
        for (int end = 0; end < 2; ++end)
          if (!around[k] && cell(c)[k] == end * (cells[k] - 1))
            mesh.sides[side_names[k][end]].push_back(facet_nodes(mesh, {c, 2 * k + end}));
    }
    return mesh;
  }
};

}  // namespace detail

/// A box \f$[lower, upper]\f$ of box-like cells, node (i, j, k) being number \f$i + n_0(j + n_1k)\f$. Sides
/// across a direction that is not periodic: left and right, bottom and top, front and back.
///
/// \snippet media.cpp box_mesh
/// @param lower, upper  opposite corners, length; as many coordinates as the body has dimensions, 1 to 3
/// @param cells         how many along each direction; at least two along a periodic one
/// @param periodic      along which directions the far side is the near one; empty: along none
/// @throws NotABodyMesh  where these do not fit together, or there are no cells, or too many to count
/// @throws NotFinite     where a corner is none
/// Accuracy: places to a rounding of the larger coordinate.
BodyMesh box_mesh(std::vector<double> const& lower, std::vector<double> const& upper,
                  std::vector<int> const& cells, std::vector<bool> const& periodic = {});

}  // namespace actio::media
