#include "program/registry/system.hpp"

#include "program/registry/conservation.hpp"

// One line for each system, in the order in which they are told: systems/NAME.cpp defines NAME_system().
// clang-format off
#define ACTIO_EACH_SYSTEM(with) \
  with(rigid_body)              \
  with(rigid_body_n)            \
  with(heavy_top)               \
  with(euler_poincare)          \
  with(vorticity_sphere)        \
  with(vorticity_torus)         \
  with(barotropic_fluid)        \
  with(elastic_body)            \
  with(incompressible_fluid)    \
  with(incompressible_body)     \
  with(fluid_on_sphere)         \
  with(two_bodies)              \
  with(rod)
// clang-format on

namespace actio::scene {

#define ACTIO_DECLARED(name) System name##_system();
ACTIO_EACH_SYSTEM(ACTIO_DECLARED)
#define ACTIO_MADE(name) name##_system(),

std::vector<System> const& systems() {
  static std::vector<System> const all = [] {
    std::vector<System> made{ACTIO_EACH_SYSTEM(ACTIO_MADE)};
    for (auto& system : made) system.quantities = with_conserved(system.name, std::move(system.quantities));
    return made;
  }();
  return all;
}

System const* find_system(std::string const& name) {
  for (auto const& system : systems())
    if (system.name == name) return &system;
  return nullptr;
}

std::unique_ptr<RankPart> part_of_motion(std::string const& scene, double number) {
  SceneFile const file = SceneFile::parse(scene, "the scene of rank 0");
  return find_system(file.section("system").text("kind"))->part(file, number);
}

}  // namespace actio::scene
