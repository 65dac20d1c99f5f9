#include "actio/scene/systems/medium_memory.hpp"

#include <algorithm>

namespace actio::scene {

double bytes_for_medium(MediumMesh const& mesh, bool fast, SnapshotRequest const* snapshots) {
  double const nodes = mesh.node_count(), cells = mesh.cell_count(), d = mesh.dimension;
  constexpr double program = 16e6;
  if (fast) {
    // The state and its copy; then at the start the linearised forces for the longest step.
    double const kept = 64 * nodes;
    double besides = 112 * nodes;
    if (snapshots) besides = std::max(besides, 200 * nodes);
    return program + kept + besides;
  }
  bool const simplices = mesh.read && is_simplex(mesh.read->shape);
  double const points = simplices || d == 1 ? 1 : d == 2 ? 4 : 8;
  double const of_mesh = 24 * nodes + 32 * cells, of_points = points * 8 * (d * d + 2) * cells;
  return program + 2 * of_mesh + of_points + 16 * 8 * d * nodes;
}

}  // namespace actio::scene
