// The media of the library that the fast road steps, chosen by their names.
#pragma once

#include <cmath>

#include "program/systems/media/fast_motion.hpp"

namespace actio::scene {

/// Whether a power gamma of the volume of a cell is far from the ends of double precision, whatever the cell
/// is compressed or stretched to by a factor of sixteen.
template <class Box>
bool has_power(Box const& box, double gamma) {
  return gamma * (std::abs(std::log2(box.measure())) + 4) < 900;
}

/// Of a fluid of the library. Null where the fast road does not know it.
template <class Box>
std::unique_ptr<FastRoad<Box::dimension>> fluid_on_fast_road(Material const& material, Box const& box,
                                                             double density) {
  std::string const& name = material.record->name;
  auto const& c = material.constants;
  if (name == "shallow_water")
    return fast_road_of(media::FastFluid{media::PolytropicByRoots<1, 2>{c[0] / 2 * density}}, box, density);
  if (name == "polytropic_gas" && c[1] == 2)
    return fast_road_of(media::FastFluid{media::PolytropicByRoots<1, 2>{c[0] * density}}, box, density);
  if (!has_power(box, c[1])) return nullptr;
  if (name == "polytropic_gas")
    return fast_road_of(media::FastFluid{GasLaw{c[0] * std::pow(density, c[1] - 1), c[1], 0}}, box, density);
  if (name == "tait")
    return fast_road_of(media::FastFluid{GasLaw{c[0] / density, c[1], c[0] / density}}, box, density);
  return nullptr;
}

/// Of a solid; likewise.
template <class Box>
std::unique_ptr<FastRoad<Box::dimension>> solid_on_fast_road(Material const& material, Box const& box,
                                                             double density) {
  std::string const& name = material.record->name;
  auto const& c = material.constants;
  if (name == "saint_venant_kirchhoff")
    return fast_road_of(media::FastStVenantKirchhoff{c[0] / density, c[1] / density}, box, density);
  if (name == "neo_hookean") {
    double const mu = c[0] / density, kappa = c[1] / density;
    return fast_road_of(media::FastNeoHookean{mu, media::ReciprocalLaw{mu, kappa, kappa}}, box, density);
  }
  return nullptr;
}

}  // namespace actio::scene
