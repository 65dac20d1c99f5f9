// The cells of a medium as other programs count their corners, drawn whole across the seams of a periodic
// box.
#pragma once

#include <cstdint>
#include <map>
#include <utility>
#include <vector>

#include "program/medium_output/motion.hpp"

namespace actio::scene {

/// The number that VTK has for cells of a shape.
inline unsigned char vtk_type(media::BodyMesh::Shape shape) {
  static constexpr unsigned char types[] = {3, 5, 9, 10, 12};
  return types[static_cast<int>(shape)];
}
/// The corner of a cell that VTK counts as number k: around the faces of box-like ones.
inline std::size_t vtk_corner(media::BodyMesh::Shape shape, std::size_t k) {
  bool const boxlike =
      shape == media::BodyMesh::Shape::quadrilateral || shape == media::BodyMesh::Shape::hexahedron;
  return boxlike ? k ^ (k >> 1 & 1) : k;
}

/// Points of a grid: the nodes, and beyond the seams of a periodic box once more those that cells need. Only
/// the latter take memory.
template <int d>
class GridPoints {
 public:
  /// A node, with bits of the periods by which a point lies beyond it.
  using Point = std::pair<std::size_t, unsigned char>;

  /// @param cells  outlive it
  explicit GridPoints(MediumCells<d> const& cells)
      : cells_(cells), corners_(static_cast<std::size_t>(media::corner_count(cells.shape()))) {
    bool around = false;
    for (int a = 0; a < d; ++a) around = around || cells.period(a) != 0;
    for (std::size_t c = 0; around && c < cells.cells(); ++c) {
      auto const cell = cells.cell(c);
      for (std::size_t k = 0; k < corners_; ++k) {
        std::size_t const b = vtk_corner(cells.shape(), k);
        if (cell.wraps[b] == 0) continue;
        Point const point{static_cast<std::size_t>(cell.nodes[b]), cell.wraps[b]};
        if (number_.try_emplace(point, size()).second) beyond_.push_back(point);
      }
    }
  }
  /// How many points there are.
  std::size_t size() const { return cells_.nodes() + beyond_.size(); }
  /// A point by its number: first the nodes.
  Point operator[](std::size_t k) const {
    return k < cells_.nodes() ? Point{k, 0} : beyond_[k - cells_.nodes()];
  }
  /// The points at the corners of all cells, one cell after the other and its corners as VTK counts them:
  /// number k of them. It is quick where k grows by one from call to call.
  std::int64_t corner(std::size_t k) {
    if (std::size_t const c = k / corners_; c != at_) cell_ = cells_.cell(c), at_ = c;
    std::size_t const b = vtk_corner(cells_.shape(), k % corners_);
    auto const node = static_cast<std::size_t>(cell_.nodes[b]);
    return static_cast<std::int64_t>(cell_.wraps[b] == 0 ? node : number_.at({node, cell_.wraps[b]}));
  }
  /// How many corners all cells have.
  std::size_t corners() const { return corners_ * cells_.cells(); }

 private:
  MediumCells<d> const& cells_;
  std::size_t corners_;
  std::vector<Point> beyond_;
  std::map<Point, std::size_t> number_;
  typename MediumCells<d>::Cell cell_{};
  std::size_t at_ = ~std::size_t{0};
};

}  // namespace actio::scene
