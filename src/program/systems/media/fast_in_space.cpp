// Media of the library in space in the optimised implementation.
// In a unit of its own
#include "actio/fast_media/fast_medium_3d.hpp"
#include "program/systems/media/fast_media.hpp"

namespace actio::scene {

std::unique_ptr<OptimisedMedium<3>> optimised_medium(Material const& material, media::FastBox3d const& box,
                                                     double density) {
  return optimised_medium_on(material, box, density);
}

}  // namespace actio::scene
