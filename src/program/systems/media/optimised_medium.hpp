// Media on boxes of cells of one size and density, by the fused steps of the optimised implementation.
#pragma once

#include "actio/fast_media/fast_box_3d.hpp"
#include "actio/fast_media/nodes_on_ranks.hpp"
#include "program/medium_output/motion.hpp"
#include "program/systems/media/input.hpp"
#include "program/systems/media/material.hpp"

namespace actio::scene {

/// The cells of a box of the optimised implementation.
/// @tparam Box  `FastBox2d` or `FastBox3d`
template <class Box>
class BoxCells final : public MediumCells<Box::dimension> {
 public:
  static constexpr int d = Box::dimension;  ///< of the body, and of space
  using typename MediumCells<d>::Place;     ///< a point, or a vector
  using typename MediumCells<d>::Cell;      ///< the corners of one
  using Index = std::array<int, d>;         ///< of a node or a cell along each direction

  /// @param box  the cells
  explicit BoxCells(Box const& box) : box_(box) {}
  media::BodyMesh::Shape shape() const override {
    return d == 2 ? media::BodyMesh::Shape::quadrilateral : media::BodyMesh::Shape::hexahedron;
  }
  std::size_t nodes() const override { return static_cast<std::size_t>(box_.count()); }
  std::size_t cells() const override {
    std::size_t count = 1;
    for (int const n : box_.cells) count *= static_cast<std::size_t>(n);
    return count;
  }
  Place reference(std::size_t node) const override { return box_.at(node_at(node)); }
  Cell cell(std::size_t number) const override {
    Index const at = cell_at(number);
    Cell out;
    for (int b = 0; b < 1 << d; ++b) {
      int node = 0;
      for (int a = d - 1; a >= 0; --a) {
        int k = at[static_cast<std::size_t>(a)] + (b >> a & 1);
        if (k == box_.nodes(a)) k = 0, out.wraps[static_cast<std::size_t>(b)] |= 1 << a;
        node = node * box_.nodes(a) + k;
      }
      out.nodes[static_cast<std::size_t>(b)] = node;
    }
    return out;
  }
  double period(int k) const override {
    auto const a = static_cast<std::size_t>(k);
    return box_.periodic(k) ? box_.cells[a] * box_.spacing[a] : 0;
  }
  std::string name(std::size_t number) const override {
    std::string out;
    for (int const k : cell_at(number)) out += (out.empty() ? "cell (" : ", ") + std::to_string(k);
    return out + ")";
  }
  /// The box.
  Box const& box() const { return box_; }
  /// Where a node is among those of the box.
  Index node_at(std::size_t number) const {
    return split(number, [&](int a) { return box_.nodes(a); });
  }

 private:
  Index cell_at(std::size_t number) const {
    return split(number, [&](int a) { return box_.cells[static_cast<std::size_t>(a)]; });
  }
  /// The first direction is the fastest.
  template <class Length>
  static Index split(std::size_t number, Length const& length) {
    Index out;
    for (int a = 0; a < d; ++a) {
      auto const n = static_cast<std::size_t>(length(a));
      out[static_cast<std::size_t>(a)] = static_cast<int>(number % n), number /= n;
    }
    return out;
  }
  Box box_;
};

/// The box of a mesh of the scene, where the optimised implementation takes it.
/// @return none where it is no box of that dimension
template <class Box>
std::optional<Box> fast_box(MediumMesh const& mesh) {
  if (mesh.shape != "box" || mesh.dimension != Box::dimension) return {};
  Box box{};
  for (std::size_t a = 0; a < Box::dimension; ++a) {
    box.cells[a] = mesh.cells[a], box.origin[a] = mesh.lower[a];
    box.spacing[a] = (mesh.upper[a] - mesh.lower[a]) / mesh.cells[a];
    for (int end = 0; end < 2; ++end) {
      std::string const name = actio::media::detail::side_names[a][end];
      box.ends(static_cast<int>(a))[static_cast<std::size_t>(end)] =
          mesh.periodic[a] ? media::Side::periodic : mesh.sides.at(name);
    }
  }
  return box;
}

/// A medium that the optimised implementation steps.
template <int d>
class OptimisedMedium {
 public:
  virtual ~OptimisedMedium() = default;
  /// The longest step for which small motions about these places are stable, from above within a per cent.
  virtual double longest_step(std::vector<std::array<double, d>> const& x) const = 0;
  /// The motion from the start.
  /// @param longest  what \ref longest_step is there
  /// @param scene    as a text, for the other ranks
  virtual std::unique_ptr<MediumMotion<d>> motion(double step, double longest,
                                                  std::shared_ptr<MediumStart> start,
                                                  std::string const& scene) const = 0;
  /// The part of it on this rank, which is not the first.
  virtual std::unique_ptr<RankPart> part(double step) const = 0;
};
/// Of a material in the plane. Null where the optimised implementation does not know it.
std::unique_ptr<OptimisedMedium<2>> optimised_medium(Material const& material, media::FastBox2d const& box,
                                                     double density);
/// In space; likewise.
std::unique_ptr<OptimisedMedium<3>> optimised_medium(Material const& material, media::FastBox3d const& box,
                                                     double density);

}  // namespace actio::scene
