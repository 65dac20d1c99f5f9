// Maps of the snapshots of a run on the torus.
#include <algorithm>

#include "program/systems/sphere/flow_maps.hpp"
#include "program/systems/torus/input.hpp"
#include "program/systems/torus/snapshots.hpp"

namespace actio::scene {
namespace {

/// On at least so many points that a cubic between them shows no grid.
FlowMaps flat_maps_of(Scene const& scene) {
  return {true, [&scene](std::string const& path) -> FlowMaps::Values {
            int const n = torus_keys.N.read(scene.file), points = std::max(n, 128);
            torus::GridValues const turned =
                torus::values_on_grid(read_torus_harmonics_file(path, n), points).transpose();
            return {points, points, {turned.data(), turned.data() + turned.size()}};
          }};
}

}  // namespace

std::string torus_maps_json(Scene const& scene, std::string const& folder) {
  return flat_maps_of(scene).json(scene, folder);
}

std::string torus_map(Scene const& scene, std::string const& folder, double width) {
  return flat_maps_of(scene).picture(scene, folder, width);
}

}  // namespace actio::scene
