// Where a run is: how many steps, rows and snapshots it has, and whether a row or a snapshot is next.
#pragma once

#include <chrono>
#include <optional>
#include <string>

#include "program/run/progression.hpp"

namespace actio::scene {

/// What a run writes next.
enum class Next {
  row,      ///< a row of its table
  snapshot  ///< a snapshot of its field
};

/// The position of a run of one scene, from its start to its last row and snapshot.
class RunPosition {
 public:
  /// @param scene      outlives it
  /// @param snapshots  whether the run writes those that the scene asks for
  /// @throws SceneError  where a row or a snapshot is at no multiple of the step
  RunPosition(Scene const& scene, bool snapshots);

  long steps() const { return at_.steps; }             ///< taken; at their product with the length
  long rows() const { return at_.rows; }               ///< written
  long snapshots() const { return taken_.snapshots; }  ///< written
  bool with_snapshots() const { return snapshots_; }   ///< whether there are any to write
  /// Whether all rows and snapshots are written.
  bool at_end() const;
  /// What is next: a row where there is one before the next snapshot, or at the same time.
  Next next() const;
  double time_of(Next what) const;       ///< of the next row or snapshot
  long steps_to(Next what) const;        ///< whole steps from t = 0 to it, of a method with steps
  double beyond_steps(Next what) const;  ///< the time from there to it: zero, or less than a step
  /// The time from the last whole step before the last row of the scene to that row.
  double beyond_steps_to_last_row() const;

  /// Goes on from another position with steps of the length that this scene has.
  /// @return the length of the step that leads there first, zero where it needs none
  /// @throws SceneError  where a row or a snapshot lies within it
  double change_step(RunPosition const& before);
  /// Where the steps had another length before.
  StepChanges const& step_changes() const { return changes_; }
  long steps_of_any_length() const { return at_.steps + at_.besides; }  ///< taken

  void made(long steps) { at_.steps += steps; }                           ///< steps
  void wrote_row(double t) { ++at_.rows, at_.time = t; }                  ///< at this time
  void wrote_snapshot(double t) { ++taken_.snapshots, taken_.time = t; }  ///< at this time

  /// Steps, or rows where there are no steps.
  long count() const { return exact_ ? at_.rows : at_.steps; }
  long count_of_whole_run() const;  ///< the same at its end
  double fraction() const;          ///< the quotient of the two
  double time() const;              ///< of the last row, or step where there are steps
  /// Of this process and those before it.
  double seconds() const;

  /// Saves, or restores, the position.
  void remember(CheckpointStream& stream);
  /// That the scene has what was restored.
  /// @param checkpoint  its path
  /// @throws SceneError  where the scene, which may go further than it did, has other rows or snapshots
  /// @throws FileError   where no run of the scene can be there
  void check(std::string const& checkpoint) const;

 private:
  using Clock = std::chrono::steady_clock;

  Schedule const& schedule_of(Next what) const {
    return what == Next::row ? scene_.schedule : *scene_.snapshots;
  }
  long number(Next what) const { return what == Next::row ? at_.rows : taken_.snapshots; }
  StepsToRows const& steps_of(Next what) const {
    return what == Next::row ? *steps_to_rows_ : *steps_to_snapshots_;
  }

  Scene const& scene_;
  bool exact_, snapshots_;
  std::optional<StepsToRows> steps_to_rows_, steps_to_snapshots_;
  Progression at_;  // its seconds: those of the processes before
  Taken taken_;
  StepChanges changes_;
  Clock::time_point began_ = Clock::now();
};

}  // namespace actio::scene
