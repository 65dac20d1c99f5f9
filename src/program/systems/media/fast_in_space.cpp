// Media of the library in space on the fast road.
// In a unit of its own
#include "actio/fast_media/fast_medium_3d.hpp"
#include "program/systems/media/fast_media.hpp"

namespace actio::scene {

std::unique_ptr<FastRoad<3>> fast_road(Material const& material, media::FastBox3d const& box,
                                       double density) {
  return fast_road_on(material, box, density);
}

}  // namespace actio::scene
