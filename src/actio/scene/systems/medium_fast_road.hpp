// Media on boxes of cells of one size and density, by the fused steps of the fast road.
#pragma once

#include "actio/multisymplectic/fast_box_2d.hpp"
#include "actio/scene/systems/medium_input.hpp"
#include "actio/scene/systems/medium_material.hpp"
#include "actio/scene/systems/medium_motion.hpp"

namespace actio::scene {

/// The cells of a box of the fast road.
class BoxCells final : public MediumCells<2> {
 public:
  /// @param box  the cells
  explicit BoxCells(FastBox2d const& box) : box_(box) {}
  BodyMesh::Shape shape() const override { return BodyMesh::Shape::quadrilateral; }
  std::size_t nodes() const override { return static_cast<std::size_t>(box_.count()); }
  std::size_t cells() const override {
    return static_cast<std::size_t>(box_.cells[0]) * static_cast<std::size_t>(box_.cells[1]);
  }
  Place reference(std::size_t node) const override {
    auto const n = static_cast<std::size_t>(box_.nodes(0));
    return box_.at(static_cast<int>(node % n), static_cast<int>(node / n));
  }
  Cell cell(std::size_t number) const override {
    auto const [i, j] = at(number);
    Cell out;
    for (int b = 0; b < 4; ++b) {
      int k[2] = {i + (b & 1), j + (b >> 1)};
      for (int a = 0; a < 2; ++a)
        if (k[a] == box_.nodes(a))
          k[a] = 0, out.wraps[static_cast<std::size_t>(b)] |= static_cast<unsigned char>(1 << a);
      out.nodes[static_cast<std::size_t>(b)] = k[0] + box_.nodes(0) * k[1];
    }
    return out;
  }
  double period(int k) const override { return box_.periodic(k) ? box_.cells[k] * box_.spacing[k] : 0; }
  std::string name(std::size_t number) const override {
    auto const [i, j] = at(number);
    return "cell (" + std::to_string(i) + ", " + std::to_string(j) + ")";
  }
  /// The box.
  FastBox2d const& box() const { return box_; }

 private:
  std::array<int, 2> at(std::size_t number) const {
    auto const n = static_cast<std::size_t>(box_.cells[0]);
    return {static_cast<int>(number % n), static_cast<int>(number / n)};
  }
  FastBox2d box_;
};

/// The box of a mesh of the scene, where the fast road takes it.
/// @return none where it is no box in the plane
std::optional<FastBox2d> fast_box(MediumMesh const& mesh);

/// A medium that the fast road steps.
class FastRoad {
 public:
  virtual ~FastRoad() = default;
  /// The longest step for which small motions about these places are stable, from above within a per cent.
  virtual double longest_step(std::vector<std::array<double, 2>> const& x) const = 0;
  /// The motion from the start.
  virtual std::unique_ptr<MediumMotion<2>> motion(double step, std::shared_ptr<MediumStart> start) const = 0;
};
/// Of a fluid of the library. Null where the fast road does not know it.
std::unique_ptr<FastRoad> fast_fluid(Material const& material, FastBox2d const& box, double density);
/// Of a solid of the library; likewise.
std::unique_ptr<FastRoad> fast_solid(Material const& material, FastBox2d const& box, double density);

}  // namespace actio::scene
