// What snapshots of a rod hold, and their files: a table of the sections and one of the elements, and lines
// with the axes of the sections for ParaView.
#pragma once

#include "program/registry/system.hpp"
#include "program/systems/rods/motion.hpp"

namespace actio::scene {

/// What they can hold.
SnapshotKind rod_snapshots();
/// What writes them.
/// @param motion  outlives the writer
/// @return null where the scene asks for none
std::unique_ptr<SnapshotWriter> write_rod(Request const& request, RodScene const& scene,
                                          RodMotion const& motion);

}  // namespace actio::scene
