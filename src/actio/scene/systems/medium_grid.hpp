// The cells of a medium as other programs count their corners, drawn whole across the seams of a periodic
// box.
#pragma once

#include <cstdint>
#include <map>
#include <utility>
#include <vector>

#include "actio/scene/systems/medium_motion.hpp"

namespace actio::scene {

/// The number that VTK has for cells of a shape.
inline unsigned char vtk_type(BodyMesh::Shape shape) {
  static constexpr unsigned char types[] = {3, 5, 9, 10, 12};
  return types[static_cast<int>(shape)];
}
/// The corner of a cell that VTK counts as number k: around the faces of box-like ones.
inline std::size_t vtk_corner(BodyMesh::Shape shape, std::size_t k) {
  bool const boxlike = shape == BodyMesh::Shape::quadrilateral || shape == BodyMesh::Shape::hexahedron;
  return boxlike ? k ^ (k >> 1 & 1) : k;
}

/// Points of a grid: the nodes, and beyond the seams of a periodic box once more those that cells need.
struct GridPoints {
  std::vector<std::pair<std::size_t, unsigned char>> of;  ///< nodes, with bits of the periods beyond
  std::vector<std::int64_t> corners;                      ///< points of all cells, as VTK counts them
};

/// Those of a medium.
template <int d>
GridPoints grid_points(MediumCells<d> const& cells) {
  GridPoints out;
  for (std::size_t k = 0; k < cells.nodes(); ++k) out.of.push_back({k, 0});
  std::map<std::pair<int, unsigned char>, std::int64_t> beyond;
  auto const corners = static_cast<std::size_t>(corner_count(cells.shape()));
  out.corners.reserve(cells.cells() * corners);
  for (std::size_t c = 0; c < cells.cells(); ++c) {
    auto const cell = cells.cell(c);
    for (std::size_t k = 0; k < corners; ++k) {
      std::size_t const b = vtk_corner(cells.shape(), k);
      int const node = cell.nodes[b];
      unsigned char const wrap = cell.wraps[b];
      if (wrap == 0) {
        out.corners.push_back(node);
        continue;
      }
      auto const [at, is_new] = beyond.try_emplace({node, wrap}, static_cast<std::int64_t>(out.of.size()));
      if (is_new) out.of.push_back({static_cast<std::size_t>(node), wrap});
      out.corners.push_back(at->second);
    }
  }
  return out;
}

}  // namespace actio::scene
