// Maps of the snapshots of a run on the sphere.
#include <algorithm>

#include "actio/sphere_fields/sphere_transform.hpp"
#include "actio/sphere_fields/symbols.hpp"
#include "program/systems/sphere/flow_maps.hpp"
#include "program/systems/sphere/input.hpp"
#include "program/systems/sphere/snapshots.hpp"

namespace actio::scene {
namespace {

/// Parallels that tell a field of the degrees below n, with a quarter to spare; less of a large one, whose
/// finest scales are filaments narrower than a pixel.
int rows_for(int n) { return std::clamp(5 * n / 4, 90, 256) / 2 * 2; }

/// On a grid of equal angles.
FlowMaps maps_of(Scene const& scene) {
  return {false, [&scene](std::string const& path) -> FlowMaps::Values {
            int const n = sphere_keys.N.read(scene.file), rows = rows_for(n);
            sphere::Symbol const symbol = symbol_keys.symbol.find(scene.file) == "weyl"
                                              ? sphere::Symbol::weyl
                                              : sphere::Symbol::berezin;
            auto const field = sphere::values_on(sphere::SphereGrid::uniform(rows, 2 * rows),
                                                 sphere::symbol_of(read_harmonics_file(path, n), symbol));
            return {rows, 2 * rows, {field.data(), field.data() + field.size()}};
          }};
}

}  // namespace

std::string vorticity_maps_json(Scene const& scene, std::string const& folder) {
  return maps_of(scene).json(scene, folder);
}

std::string vorticity_map(Scene const& scene, std::string const& folder, double width) {
  return maps_of(scene).picture(scene, folder, width);
}

}  // namespace actio::scene
