// Solids of the library on the fast road.
#include "actio/scene/systems/medium_fast_motion.hpp"

namespace actio::scene {

std::unique_ptr<FastRoad> fast_solid(Material const& material, FastBox2d const& box, double density) {
  std::string const& name = material.record->name;
  auto const& c = material.constants;
  if (name == "saint_venant_kirchhoff")
    return fast_road_of(FastStVenantKirchhoff{c[0] / density, c[1] / density}, box, density);
  if (name == "neo_hookean") {
    double const mu = c[0] / density, kappa = c[1] / density;
    return fast_road_of(FastNeoHookean{mu, ReciprocalLaw{mu, kappa, kappa}}, box, density);
  }
  return nullptr;
}

}  // namespace actio::scene
