#include "actio/scene/system.hpp"

namespace actio::scene {

std::vector<System> const& systems() {
  static std::vector<System> const all{rigid_body_system(), rigid_body_n_system(), heavy_top_system()};
  return all;
}

System const* find_system(std::string const& name) {
  for (auto const& system : systems())
    if (system.name == name) return &system;
  return nullptr;
}

}  // namespace actio::scene
