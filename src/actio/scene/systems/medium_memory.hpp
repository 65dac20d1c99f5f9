// How much memory a medium takes.
#pragma once

#include <string>
#include <vector>

#include "actio/scene/snapshots.hpp"
#include "actio/scene/systems/medium_input.hpp"

namespace actio::scene {

/// The memory that a run takes at most, in bytes: what the program has without one, and for each node and
/// cell the states, their copies, and the most that is there besides at one time: while the run begins, a
/// row, a checkpoint or a snapshot is made.
/// @param fast       whether the fast road steps it
/// @param snapshots  null: there are none
/// Accuracy: measured to be within 5 % from some ten thousand nodes on; with snapshots within a tenth, since
/// numbers have as many digits, and grids are compressed as far, as they are.
double bytes_for_medium(MediumMesh const& mesh, bool fast, SnapshotRequest const* snapshots);

}  // namespace actio::scene
