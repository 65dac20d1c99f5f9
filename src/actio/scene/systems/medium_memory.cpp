#include "actio/scene/systems/medium_memory.hpp"

#include <algorithm>

#include "actio/scene/systems/medium_fields.hpp"

namespace actio::scene {
namespace {

/// What a snapshot takes while it is made, for each node: places, velocities, fields, and its text.
double bytes_of_snapshot(SnapshotRequest const& snapshots, int dimension) {
  double const d = dimension, columns = dimension == 1   ? field_size<1>(snapshots.columns)
                                        : dimension == 2 ? field_size<2>(snapshots.columns)
                                                         : field_size<3>(snapshots.columns);
  bool const grids = snapshots.in("vtu"), frames = snapshots.in("hdf5"), tables = snapshots.in("csv");
  return std::max({tables ? 155 * d + 40 * columns : 0.0,
                   grids ? (dimension == 3 ? 1150 : 260) + 4 * columns : 0.0,
                   frames ? 55 * d + 16 * columns : 0.0});
}

/// The state, its copy, and what is there while a row or a checkpoint is made, given what one vector at each
/// node takes; measured. What is freed goes back to the system at once where it is larger than 32 MB, states
/// of two vectors first, and otherwise is kept by the process.
double bytes_on_fast_road(double vectors) {
  double const at_once = 33554432;
  return vectors * (2 * vectors < at_once ? 14.8 : vectors < at_once ? 12.2 : 11.1);
}

}  // namespace

double bytes_for_medium(MediumMesh const& mesh, bool fast, SnapshotRequest const* snapshots) {
  double const nodes = mesh.node_count(), cells = mesh.cell_count(), d = mesh.dimension;
  double const transient = snapshots ? bytes_of_snapshot(*snapshots, mesh.dimension) * nodes : 0;
  constexpr double program = 11e6;
  if (fast) return program + std::max(bytes_on_fast_road(8 * d * nodes), 32 * d * nodes + transient);
  bool const simplices = mesh.read && is_simplex(mesh.read->shape);
  double const points = simplices || d == 1 ? 1 : d == 2 ? 4 : 8;
  // Nodes and cells twice, points with their inverse edges, states and forces; measured, seven ninths of that
  // are kept, and up to twelve ninths are there when the run begins.
  double const body = 2 * (24 * nodes + 32 * cells) + 8 * points * (d * d + 2) * cells + 16 * 8 * d * nodes;
  return program + std::max(1.28 * body, 0.79 * body + transient);
}

}  // namespace actio::scene
