// When a scene has rows: [run].
//
// A method with steps has its rows at multiples of the step. With `between_steps` a row may be at any time:
// one shorter step of the same scheme goes there from the last step before it, for that row alone, and the
// steps go on as if there were no such row.
//
// With `every`: t = 0, then k * every (multiplied, never accumulated), then `until` where it is not among
// them. With `at`: these times. With neither: the first and the last.
#pragma once

#include "program/document/key.hpp"

namespace actio::scene {

/// Numbers that increase, from 0 on.
inline Pattern<std::vector<double>> const increasing_times =
    Patterns::numbers("a list of numbers, each greater than the one before, from 0 to run.until").in("time");

/// [run]
struct RunKeys : KeyTable {
  Key<double> until = key("until", positive.in("time"), LeftOut{"needed; with run.at the last of its times"},
                          "The time at which the run ends; it begins at 0.", "10");
  Key<double> every =
      key("every", positive.in("time"), LeftOut{"or run.at; with neither, rows at 0 and at run.until"},
          "The time from row to row: there are rows at its multiples, from 0 on, and at run.until.", "0.1");
  Key<std::vector<double>> at =
      key("at", increasing_times, LeftOut{"or run.every; with neither, rows at 0 and at run.until"},
          "The times of the rows.", "[0, 0.5, 2]");
  Key<bool> between_steps = key(
      "between_steps", truth,
      LeftOut{"false; true where no step is given and the default step does not divide the times of the "
              "rows"},
      "Whether rows may lie between two steps: one shorter step of the same scheme goes to each of these, "
      "for that row alone. It changes nothing where the method is exact.",
      "true");
};
inline RunKeys const run_keys{{"run"}};  ///< its keys

/// When [output] has snapshots.
struct SnapshotTimesKeys : KeyTable {
  Key<std::vector<double>> at =
      key("snapshot_at", increasing_times,
          LeftOut{"or output.snapshot_every; with neither, snapshots at 0 and at run.until"},
          "The times of the snapshots.", "[0.5, 1]");
  Key<double> every =
      key("snapshot_every", positive.in("time"),
          LeftOut{"or output.snapshot_at; with neither, snapshots at 0 and at run.until"},
          "The time from snapshot to snapshot: there are some at its multiples, from 0 on, and at run.until.",
          "0.5");
};
inline SnapshotTimesKeys const snapshot_times_keys{{"output"}};  ///< its keys

/// The times of the rows.
class Schedule {
 public:
  /// Reads [run] and writes its defaults back.
  /// @throws SceneError  where a time is not positive, beyond `until`, or not later than the one before;
  ///                     where there are more than 2^53 rows
  explicit Schedule(SceneTable run);
  /// Those of the snapshots: `snapshot_at` or `snapshot_every` of [output]; with neither, the first and the
  /// last.
  /// @throws SceneError  as for the rows
  Schedule(SceneTable const& output, Schedule const& rows);

  double until() const { return until_; }  ///< the time of the last row
  /// Whether rows between two steps are reached by a shorter step.
  bool between_steps() const { return between_steps_; }
  /// From now on they are.
  void allow_between_steps() { between_steps_ = true; }
  long rows() const { return rows_; }  ///< how many rows there are, that of t = 0 included
  /// Of row 0, 1, ..., `rows()` - 1.
  double time(long row) const;
  /// Times of which all others are multiples or that stand alone: `every` and `until`, or those of `at`; and
  /// those that steps are to meet besides.
  std::vector<double> landmarks() const;
  /// That steps are to meet those of another schedule as well.
  void meet(Schedule const& other);
  /// Whether there is another one.
  bool has_others() const { return !besides_.empty(); }
  /// The longest time that divides all others; zero where they have none in common.
  double common_divisor() const;
  /// Whether every row is at a multiple of the step, |t/h - round| <= 1e-9 max(1, t/h).
  bool met_by(double step) const;
  /// The longest step of which every row is a multiple and that is at most this long; zero where there is
  /// none.
  double step_up_to(double longest) const;
  /// The longest step that divides all times and is at most so long. Where that makes more than four times as
  /// many steps as one would that divides the time between two rows, or the whole time, and goes to the other
  /// rows by shorter steps, the latter.
  double default_step(double longest) const;
  /// The shortest that is at least this long; zero where there is none.
  double step_from(double shortest) const;

 private:
  double until_ = 0, every_ = 0;
  bool last_beside_ = false;  // until is no multiple of every
  bool between_steps_ = false;
  std::vector<double> at_;
  long rows_ = 0;
  std::vector<double> besides_;  // landmarks of another schedule

  void read_times(SceneTable const& table, Key<std::vector<double>> const& key, bool bounded);
  void read_interval(SceneTable const& table, Key<double> const& key);
};

/// The number of steps to each row, for a method with steps.
class StepsToRows {
 public:
  /// @param method  where the step was read from, for the complaint
  /// @throws SceneError  where a row is at no multiple of the step, |t/h - round| <= 1e-9 max(1, t/h), with
  ///   the nearest step that would do; unless rows between steps are allowed
  StepsToRows(Schedule const& schedule, double step, SceneTable const& method);
  long operator()(long row) const;  ///< whole steps from t = 0
  double beyond(long row) const;    ///< the time from there to the row: zero, or less than a step

 private:
  Schedule const& schedule_;
  double step_;
};

}  // namespace actio::scene
