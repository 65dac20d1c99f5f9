// Media of the library in the plane on the fast road.
#include "actio/fast_media/fast_medium_2d.hpp"
#include "program/systems/media/fast_media.hpp"

namespace actio::scene {

std::unique_ptr<FastRoad<2>> fast_road(Material const& material, media::FastBox2d const& box,
                                       double density) {
  return fast_road_on(material, box, density);
}

}  // namespace actio::scene
