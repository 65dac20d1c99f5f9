// How far the run in a folder is, as its checkpoint tells: whether it has come to its end, or may go further.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "program/registry/scene.hpp"

namespace actio::scene {

/// How far a run is: the head of its checkpoint.
struct Progression {
  long steps = 0;      ///< taken
  long rows = 0;       ///< written
  double time = 0;     ///< of the last row
  double seconds = 0;  ///< of all processes
  long besides = 0;    ///< steps of other lengths, over those that are counted in their place
};
/// From a time on the steps had another length.
struct StepChange {
  double time = 0;    ///< of the state
  double before = 0;  ///< their length up to there
  double step = 0;    ///< and from there on
};
/// All of a run, in their order.
using StepChanges = std::vector<StepChange>;
/// `# From t = 0.5 on steps of 0.001, before of 0.002`
std::string in_words(StepChange const& change);

/// How many snapshots it has: in the checkpoints of scenes that ask for some.
struct Taken {
  long snapshots = 0;  ///< written
  double time = 0;     ///< of the last of them
};

/// That the rows so far are the first ones of the scene, which may go further than it did.
/// @throws SceneError  at this place
void check_rows(Progression const& at, Scene const& scene, Place const& place);
/// The same of snapshots.
void check_snapshots(Taken const& taken, Scene const& scene, Place const& place);

}  // namespace actio::scene
