// How much memory a medium takes.
#pragma once

#include "program/systems/media/input.hpp"

namespace actio::scene {

/// Lists of a megabyte and more are given back to the system when they are not needed any more, in this
/// process from now on. Otherwise they leave gaps between others, as they happen to, of up to a third of all.
/// It is for fused steps, which make no lists; steps that do would wait for their pages.
void keep_large_lists_apart();

/// What the program has without a run, bytes; measured.
inline constexpr double bytes_of_program = 11.5e6;

/// The memory that a run takes at most, in bytes: what the program has without one, for each node and cell
/// what is there all the time, and the most that is there besides at one time: while a step is solved, the
/// state is looked at, a checkpoint or a snapshot is written.
/// @param fast  whether fused steps are made
/// Accuracy: measured to be within 5 % from some thousand nodes on, with snapshots and without.
double bytes_for_medium(MediumMesh const& mesh, bool fast, Request const& request);

}  // namespace actio::scene
