// Media of the library in the plane in the optimised implementation.
// In a unit of its own
#include "actio/fast_media/fast_medium_2d.hpp"
#include "program/systems/media/fast_media.hpp"

namespace actio::scene {

std::unique_ptr<OptimisedMedium<2>> optimised_medium(Material const& material, media::FastBox2d const& box,
                                                     double density) {
  return optimised_medium_on(material, box, density);
}

}  // namespace actio::scene
