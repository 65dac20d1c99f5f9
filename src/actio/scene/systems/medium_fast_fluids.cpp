// Fluids of the library on the fast road.
#include <cmath>

#include "actio/scene/systems/medium_fast_motion.hpp"

namespace actio::scene {

std::optional<FastBox2d> fast_box(MediumMesh const& mesh) {
  if (mesh.shape != "box" || mesh.dimension != 2) return {};
  FastBox2d box{
      {mesh.cells[0], mesh.cells[1]},
      {(mesh.upper[0] - mesh.lower[0]) / mesh.cells[0], (mesh.upper[1] - mesh.lower[1]) / mesh.cells[1]}};
  box.origin = {mesh.lower[0], mesh.lower[1]};
  auto const side = [&](char const* name, int k) {
    if (mesh.periodic[static_cast<std::size_t>(k)]) return FastSide::periodic;
    std::string const& does = mesh.sides.at(name);
    return does == "fixed" ? FastSide::fixed : does == "sliding" ? FastSide::sliding : FastSide::free;
  };
  box.left_right = {side("left", 0), side("right", 0)};
  box.below_above = {side("bottom", 1), side("top", 1)};
  return box;
}

std::unique_ptr<FastRoad> fast_fluid(Material const& material, FastBox2d const& box, double density) {
  std::string const& name = material.record->name;
  auto const& c = material.constants;
  if (name == "shallow_water")
    return fast_road_of(FastFluid{PolytropicByRoots<1, 2>{c[0] / 2 * density}}, box, density);
  if (name == "polytropic_gas" && c[1] == 2)
    return fast_road_of(FastFluid{PolytropicByRoots<1, 2>{c[0] * density}}, box, density);
  if (name == "polytropic_gas")
    return fast_road_of(FastFluid{GasLaw{c[0] * std::pow(density, c[1] - 1), c[1], 0}}, box, density);
  if (name == "tait")
    return fast_road_of(FastFluid{GasLaw{c[0] / density, c[1], c[0] / density}}, box, density);
  return nullptr;
}

}  // namespace actio::scene
