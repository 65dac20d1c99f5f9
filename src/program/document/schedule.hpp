// When a scene has rows: [run].
//
// A method with steps has its rows at multiples of the step. With `between_steps` a row may be at any time:
// one shorter step of the same scheme goes there from the last step before it, for that row alone, and the
// steps go on as if there were no such row.
//
// With `every`: t = 0, then k * every (multiplied, never accumulated), then `until` where it is not among
// them. With `at`: these times. With neither: the first and the last.
#pragma once

#include "program/document/file.hpp"

namespace actio::scene {

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
  /// The shortest that is at least this long; zero where there is none.
  double step_from(double shortest) const;

 private:
  double until_ = 0, every_ = 0;
  bool last_beside_ = false;  // until is no multiple of every
  bool between_steps_ = false;
  std::vector<double> at_;
  long rows_ = 0;
  std::vector<double> besides_;  // landmarks of another schedule

  void read_times(SceneTable const& table, std::string const& key, bool bounded);
  void read_interval(SceneTable const& table, std::string const& key);
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
