#include "actio/meshes/body_mesh.hpp"

namespace actio::media {

std::string BodyMesh::cell_name(int cell) const {
  if (!element_tags.empty()) return "element " + std::to_string(element_tags[cell]);
  bool const in_box =
      dimension > 1 && cells.size() == std::size_t(grid[0]) * grid[1] * (dimension > 2 ? grid[2] : 1);
  if (!in_box) return "cell " + std::to_string(cell);
  std::string name = "cell (" + std::to_string(cell % grid[0]);
  for (int k = 1, left = cell / grid[0]; k < dimension; left /= grid[k], ++k)
    name += ", " + std::to_string(left % grid[k]);
  return name + ")";
}

std::array<int, 4> const& facet_corners(BodyMesh::Shape shape, int facet) {
  using Facets = std::array<std::array<int, 4>, 6>;
  static constexpr Facets facets[] = {
      Facets{{{0, -1, -1, -1}, {1, -1, -1, -1}}}, Facets{{{1, 2, -1, -1}, {2, 0, -1, -1}, {0, 1, -1, -1}}},
      Facets{{{2, 0, -1, -1}, {1, 3, -1, -1}, {0, 1, -1, -1}, {3, 2, -1, -1}}},
      Facets{{{1, 2, 3, -1}, {0, 3, 2, -1}, {0, 1, 3, -1}, {0, 2, 1, -1}}},
      Facets{{{0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}}}};
  return facets[static_cast<int>(shape)][facet];
}

std::array<int, 4> facet_nodes(BodyMesh const& mesh, CellFacet const& at) {
  auto nodes = facet_corners(mesh.shape, at.facet);
  for (int& corner : nodes)
    if (corner >= 0) corner = mesh.cells[at.cell][corner];
  return nodes;
}

std::array<double, 3> corner_place(BodyMesh const& mesh, int cell, int corner) {
  auto place = mesh.nodes[mesh.cells[cell][corner]];
  if (!mesh.wraps.empty())
    for (int k = 0; k < 3; ++k)
      if (mesh.wraps[cell][corner] >> k & 1) place[k] += mesh.periods[k];
  return place;
}

std::vector<CellFacet> facets_of_side(BodyMesh const& mesh, std::string const& side) {
  auto const found = mesh.sides.find(side);
  if (found == mesh.sides.end())
    throw NotABodyMesh("mesh of a body", "a side is among those of the mesh; sides with the name " + side, 0,
                       1);
  std::map<std::array<int, 4>, CellFacet> wanted;
  for (auto const& nodes : found->second) wanted[nodes] = {-1, -1};
  for (int cell = 0; cell < static_cast<int>(mesh.cells.size()); ++cell)
    for (int facet = 0; facet < facet_count(mesh.shape); ++facet)
      if (auto const here = wanted.find(facet_nodes(mesh, {cell, facet})); here != wanted.end())
        here->second = {cell, facet};
  std::vector<CellFacet> facets;
  for (auto const& nodes : found->second) {
    if (wanted[nodes].cell < 0)
      throw NotABodyMesh("mesh of a body, side " + side + ", facet " + std::to_string(facets.size()),
                         "a facet belongs to a cell; node", nodes[0], -1);
    facets.push_back(wanted[nodes]);
  }
  return facets;
}

namespace detail {

void CellGrid::examine() const {
  double all = 1;
  for (int k = 0; k < dimension; ++k) {
    auto const where = "mesh of a body, direction " + std::to_string(k + 1);
    if (cells[k] < 1 + around[k])
      throw NotABodyMesh(where, "there are cells enough; cells", cells[k], 1 + around[k]);
    all *= cells[k] + 1.0;
  }
  double const most = std::numeric_limits<int>::max();
  if (all > most) throw NotABodyMesh("mesh of a body", "nodes can be counted; nodes", all, most);
}

}  // namespace detail

BodyMesh box_mesh(std::vector<double> const& lower, std::vector<double> const& upper,
                  std::vector<int> const& cells, std::vector<bool> const& periodic) {
  std::size_t const d = cells.size();
  if (d < 1 || d > 3)
    throw NotABodyMesh("box", "a body has one to three dimensions; directions", double(d), 3);
  for (auto const size : {lower.size(), upper.size(), periodic.empty() ? d : periodic.size()})
    if (size != d)
      throw NotABodyMesh("box", "each direction has its entry; entries", double(size), double(d));
  detail::CellGrid grid{int(d), {1, 1, 1}};
  std::array<double, 3> low{}, high{};
  for (std::size_t k = 0; k < d; ++k) {
    low[k] = lower[k], high[k] = upper[k], grid.cells[k] = cells[k];
    grid.around[k] = !periodic.empty() && periodic[k];
    auto const where = "box, direction " + std::to_string(k + 1);
    if (!is_finite(low[k]) || !is_finite(high[k])) throw NotFinite(where);
    if (!(high[k] > low[k]))
      throw NotABodyMesh(where, "the upper end lies above the lower; end", high[k], low[k]);
  }
  auto mesh = grid.mesh([&](std::array<int, 3> const& at) {
    std::array<double, 3> place{};
    for (std::size_t k = 0; k < d; ++k) {
      double const u = double(at[k]) / grid.cells[k];
      place[k] = low[k] * (1 - u) + high[k] * u;
    }
    return place;
  });
  mesh.grid = grid.cells;
  for (std::size_t k = 0; k < d; ++k)
    if (grid.around[k]) mesh.periods[k] = high[k] - low[k];
  if (grid.around[0] || grid.around[1] || grid.around[2]) {
    mesh.wraps.resize(mesh.cells.size());
    for (std::size_t c = 0; c < mesh.cells.size(); ++c)
      for (int b = 0; b < 1 << d; ++b)
        for (std::size_t k = 0; k < d; ++k)
          if (grid.around[k] && (b >> k & 1) && grid.cell(int(c))[k] == grid.cells[k] - 1)
            mesh.wraps[c][b] |= 1 << k;
  }
  return mesh;
}

}  // namespace actio::media
