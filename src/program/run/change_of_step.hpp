// How a run goes over to steps of another length, in its motion and in its copy of the scene.
#pragma once

#include <fmt/format.h>

#include "program/run/progression.hpp"

namespace actio::scene {

/// A motion hands its state over to one with other steps.
/// @param first  the length of the step that leads to the first multiple of the new one; zero: there is none
/// @param step   the new one
/// @param made   how many of these there are up to there
/// @throws NumericsError  where the state can take no such step
inline void hand_over(Motion& before, Motion& after, double first, double step, long made) {
  try {
    before.change_step(first, step, made);
  } catch (Error const& error) {
    throw NumericsError(fmt::format("--step {}: {}", step, error.what()));
  }
  CheckpointStream saved;
  before.remember(saved);
  CheckpointStream restored(saved.bytes());
  after.remember(restored);
}

/// The copy of a scene, with remarks at its head that a run of it from its start would not have.
inline std::string with_remarks(std::string const& scene, StepChanges const& changes) {
  std::string out;
  for (auto const& change : changes) out += "# " + in_words(change) + "\n";
  return out + scene;
}

}  // namespace actio::scene
