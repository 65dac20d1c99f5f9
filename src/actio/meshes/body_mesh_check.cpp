#include "actio/meshes/body_mesh_check.hpp"

namespace actio::media {

CornerJacobian corner_jacobian(BodyMesh const& mesh, int cell, int corner) {
  int const d = mesh.dimension;
  auto const here = corner_place(mesh, cell, corner);
  double e[3][3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, box = 1;
  for (int i = 0; i < d; ++i) {
    // An edge that begins at the upper end runs backwards.
    bool const back = !is_simplex(mesh.shape) && (corner >> i & 1);
    auto const there = corner_place(mesh, cell, is_simplex(mesh.shape) ? i + 1 : corner ^ (1 << i));
    for (int k = 0; k < d; ++k) e[i][k] = back ? here[k] - there[k] : there[k] - here[k];
    box *= std::hypot(e[i][0], d > 1 ? e[i][1] : 0, d > 2 ? e[i][2] : 0);
  }
  double const det = e[0][0] * (e[1][1] * e[2][2] - e[1][2] * e[2][1]) -
                     e[0][1] * (e[1][0] * e[2][2] - e[1][2] * e[2][0]) +
                     e[0][2] * (e[1][0] * e[2][1] - e[1][1] * e[2][0]);
  return {det, box};
}

namespace detail {
namespace {

void require_nodes(BodyMesh const& mesh) {
  static constexpr int dimensions[] = {1, 2, 2, 3, 3};
  if (mesh.dimension != dimensions[int(mesh.shape)])
    throw NotABodyMesh(std::string("mesh of a body of ") + name_of(mesh.shape) + "s",
                       "it has the dimension of its cells; dimension", mesh.dimension,
                       dimensions[int(mesh.shape)]);
  if (mesh.cells.empty()) throw NotABodyMesh("mesh of a body", "there are cells; cells", 0, 1);
  if (!mesh.wraps.empty() && mesh.wraps.size() != mesh.cells.size())
    throw NotABodyMesh("mesh of a body", "each cell says how it lies across seams, or none; cells",
                       double(mesh.wraps.size()), double(mesh.cells.size()));
  for (std::size_t i = 0; i < mesh.nodes.size(); ++i)
    for (double x : mesh.nodes[i])
      if (!is_finite(x)) throw NotFinite("mesh of a body, node " + std::to_string(i));
  std::vector<bool> used(mesh.nodes.size(), false);
  for (int cell = 0; cell < int(mesh.cells.size()); ++cell)
    for (int b = 0; b < corner_count(mesh.shape); ++b) {
      int const node = mesh.cells[cell][b];
      if (node < 0 || node >= int(mesh.nodes.size()))
        throw NotABodyMesh(cell_name(mesh, cell), "its corners are nodes of the mesh; node", node,
                           double(mesh.nodes.size()) - 1, cell);
      used[node] = true;
    }
  auto const idle = std::find(used.begin(), used.end(), false);
  if (idle != used.end()) {
    auto const node = idle - used.begin();
    throw NotABodyMesh(
        "mesh of a body, node " + mesh.node_name(int(node)) + " at " + place_name(mesh.nodes[node]),
        "every node is a corner of a cell; cells at the node", 0, 1);
  }
}

void require_volumes(BodyMesh const& mesh) {
  // An entry of an edge is a difference of coordinates, and six products of them make the determinant: one
  // that is not above their rounding has no sign.
  double const bound = 64 * epsilon<double>();
  int const places = is_simplex(mesh.shape) ? 1 : corner_count(mesh.shape);
  for (int cell = 0; cell < int(mesh.cells.size()); ++cell)
    for (int b = 0; b < places; ++b) {
      auto const J = corner_jacobian(mesh, cell, b);
      if (J.volume > bound * J.box) continue;
      bool const flat = !(J.volume < -bound * J.box);
      throw NotABodyMesh(cell_name(mesh, cell) + ", corner " + std::to_string(b) + " at " +
                             place_name(corner_place(mesh, cell, b)),
                         flat ? "a cell is not degenerate; volume of the edges over their product"
                              : "a cell is not inverted; volume of the edges over their product",
                         J.box > 0 ? J.volume / J.box : 0, bound, cell);
    }
}

}  // namespace

bool is_turned(std::array<int, 4> const& nodes, int facet) {
  int count = 0, least = 0;
  for (; count < 4 && nodes[count] >= 0; ++count)
    if (nodes[count] < nodes[least]) least = count;
  if (count == 1) return facet == 1;
  if (count == 2) return least == 1;
  return nodes[(least + 1) % count] > nodes[(least + count - 1) % count];
}

namespace {

/// All facets, sorted, so that those of neighbours stand side by side.
std::vector<SortedFacet> sorted_facets(BodyMesh const& mesh) {
  std::vector<SortedFacet> facets;
  facets.reserve(mesh.cells.size() * facet_count(mesh.shape));
  for (int cell = 0; cell < int(mesh.cells.size()); ++cell)
    for (int facet = 0; facet < facet_count(mesh.shape); ++facet) {
      auto nodes = facet_nodes(mesh, {cell, facet});
      bool const turned = is_turned(nodes, facet);
      std::sort(nodes.begin(), nodes.end());
      facets.push_back({nodes, cell, turned});
    }
  std::sort(facets.begin(), facets.end(), [](SortedFacet const& a, SortedFacet const& b) {
    return std::pair(a.nodes, a.cell) < std::pair(b.nodes, b.cell);
  });
  return facets;
}

/// Its nodes, and the place of the first.
std::string facet_name(BodyMesh const& mesh, SortedFacet const& facet) {
  std::string name;
  int first = -1;
  for (int const node : facet.nodes) {
    if (node < 0) continue;
    if (first < 0) first = node;
    name += " " + mesh.node_name(node);
  }
  return name + ", from " + place_name(mesh.nodes[first]);
}

void require_one_piece(BodyMesh const& mesh) {
  auto const facets = sorted_facets(mesh);
  std::vector<int> piece(mesh.cells.size());
  std::iota(piece.begin(), piece.end(), 0);
  auto const root = [&](int cell) {
    while (piece[cell] != cell) cell = piece[cell] = piece[piece[cell]];
    return cell;
  };
  for (std::size_t k = 1; k < facets.size(); ++k) {
    auto const &here = facets[k], &other = facets[k - 1];
    if (here.nodes != other.nodes) continue;
    // In a periodic box of two cells facets with the same nodes need not be the same.
    if (mesh.wraps.empty() && k + 1 < facets.size() && here.nodes == facets[k + 1].nodes)
      throw NotABodyMesh(cell_name(mesh, facets[k + 1].cell) + ", " + mesh.cell_name(other.cell) + " and " +
                             mesh.cell_name(here.cell) + " have the same facet",
                         "a facet belongs to two cells at most; cells", 3, 2, facets[k + 1].cell);
    if (mesh.wraps.empty() && here.turned == other.turned)
      throw NotABodyMesh(cell_name(mesh, here.cell) + " lies over " + mesh.cell_name(other.cell) +
                             ": the mesh is folded along the facet" + facet_name(mesh, here),
                         "two cells with the same facet lie on both sides of it; on one side", 2, 1,
                         here.cell);
    int const a = root(here.cell), b = root(other.cell);
    piece[std::max(a, b)] = std::min(a, b);
  }
  for (int cell = 0; cell < int(mesh.cells.size()); ++cell)
    if (root(cell) != 0) {
      int pieces = 0;
      for (int c = 0; c < int(mesh.cells.size()); ++c) pieces += root(c) == c;
      throw NotABodyMesh(cell_name(mesh, cell) + " is unconnected to " + mesh.cell_name(0),
                         "cells are connected by their facets; pieces", pieces, 1, cell);
    }
}

}  // namespace
}  // namespace detail

void require_body_mesh(BodyMesh const& mesh) {
  detail::require_nodes(mesh);
  detail::require_volumes(mesh);
  detail::require_one_piece(mesh);
  for (auto const& side : mesh.sides) facets_of_side(mesh, side.first);
}

}  // namespace actio::media
