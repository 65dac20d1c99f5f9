// What snapshots of a medium hold, and their files: a table of the nodes, and grids for ParaView.
#pragma once

#include "program/medium_output/fields.hpp"
#include "program/registry/system.hpp"

namespace actio::scene {

/// What they can hold.
/// @param fluid          a solid has its stress besides
/// @param keeps_volumes  cells that do have a pressure for it
SnapshotKind medium_snapshots(bool fluid, bool keeps_volumes = false);

/// The columns of the tables.
template <int d>
std::vector<std::string> medium_columns(MediumFields<d> const& asked);

/// What writes them.
/// @param medium  its motion outlives the writer
/// @return null where the scene asks for none
template <int d>
std::unique_ptr<SnapshotWriter> write_medium(Request const& request, MediumView<d> const& medium);

}  // namespace actio::scene
