// How much memory a medium takes.
#pragma once

#include "program/base/memory.hpp"
#include "program/systems/media/input.hpp"

namespace actio::scene {

/// Lists of a megabyte and more are given back to the system when they are not needed any more, in this
/// process from now on. Otherwise they leave gaps between others, as they happen to, of up to a third of all.
/// It is for fused steps, which make no lists; steps that do would wait for their pages.
void keep_large_lists_apart();

/// The memory that a run takes at most, in bytes: what the program has without one, for each node and cell
/// what is there all the time, and the most that is there besides at one time: while a step is solved, the
/// state is looked at, a checkpoint or a snapshot is written.
/// @param fast  whether fused steps are made
/// Accuracy: measured to be within 5 % from some thousand nodes on, with snapshots and without.
double bytes_for_medium(MediumMesh const& mesh, bool fast, Request const& request);
/// Those of them that plain steps keep: on several ranks each has a part of as many more.
double bytes_of_plain_steps(MediumMesh const& mesh, Request const& request);
/// What a rank takes while it finds its part of a mesh, which it has whole until then.
double bytes_to_begin(MediumMesh const& mesh, Request const& request);
/// Those of them that fused steps have for places, velocities and their copies: what ranks share.
double bytes_of_fused_steps(MediumMesh const& mesh);

}  // namespace actio::scene
