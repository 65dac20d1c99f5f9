#include "program/run/run_position.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace actio::scene {

RunPosition::RunPosition(Scene const& scene, bool snapshots)
    : scene_(scene), exact_(scene.simulation.exact), snapshots_(snapshots) {
  if (exact_) return;
  SceneTable const method = scene.file.section("method");
  steps_to_rows_.emplace(scene.schedule, scene.simulation.step, method);
  if (snapshots_) steps_to_snapshots_.emplace(*scene.snapshots, scene.simulation.step, method);
}

bool RunPosition::at_end() const {
  return at_.rows >= scene_.schedule.rows() && !(snapshots_ && taken_.snapshots < scene_.snapshots->rows());
}
Next RunPosition::next() const {
  if (!snapshots_ || taken_.snapshots >= scene_.snapshots->rows()) return Next::row;
  if (at_.rows >= scene_.schedule.rows()) return Next::snapshot;
  bool row;
  if (exact_) {
    row = time_of(Next::row) <= time_of(Next::snapshot);
  } else {
    long const to_row = steps_to(Next::row), to_snapshot = steps_to(Next::snapshot);
    row = to_row < to_snapshot ||
          (to_row == to_snapshot && beyond_steps(Next::row) <= beyond_steps(Next::snapshot));
  }
  return row ? Next::row : Next::snapshot;
}
double RunPosition::time_of(Next what) const { return schedule_of(what).time(number(what)); }
long RunPosition::steps_to(Next what) const { return steps_of(what)(number(what)); }
double RunPosition::beyond_steps(Next what) const { return steps_of(what).beyond(number(what)); }
double RunPosition::beyond_steps_to_last_row() const {
  return steps_to_rows_->beyond(scene_.schedule.rows() - 1);
}

long RunPosition::count_of_whole_run() const {
  if (exact_) return scene_.schedule.rows();
  long const to_row = (*steps_to_rows_)(scene_.schedule.rows() - 1);
  return snapshots_ ? std::max(to_row, (*steps_to_snapshots_)(scene_.snapshots->rows() - 1)) : to_row;
}
double RunPosition::fraction() const {
  long const all = count_of_whole_run();
  return all > 0 ? static_cast<double>(count()) / static_cast<double>(all) : 1;
}
double RunPosition::time() const {
  if (!exact_) return static_cast<double>(at_.steps) * scene_.simulation.step;
  return at_.rows > 0 ? scene_.schedule.time(at_.rows - 1) : 0;
}
double RunPosition::seconds() const {
  return at_.seconds + std::chrono::duration<double>(Clock::now() - began_).count();
}

void RunPosition::remember(CheckpointStream& stream) {
  Progression place = at_;
  place.seconds = seconds();
  stream(place);
  if (stream.reading()) at_ = place;
  if (snapshots_) stream(taken_);
  stream(changes_);
}
double RunPosition::change_step(RunPosition const& before) {
  double const step = scene_.simulation.step, old = before.scene_.simulation.step, t = before.time();
  constexpr double near = 1e-9;  // as rows are near a multiple of the step
  double const ratio = t / step, tolerance = near * std::max(1.0, ratio);
  auto const made = static_cast<long>(std::ceil(ratio - tolerance));
  double const end = static_cast<double>(made) * step, first = end - t > tolerance * step ? end - t : 0;
  at_ = before.at_, taken_ = before.taken_, changes_ = before.changes_;
  if (double const next = at_end() ? end : time_of(this->next());
      first > 0 && next < end - tolerance * step) {
    SceneTable const run = scene_.file.section("run");
    throw SceneError(
        run.place(run.has("between_steps") ? "between_steps" : "until"),
        fmt::format(
            "the state is that at t = {0}, and a row at t = {1} comes before the next multiple of {2}; a "
            "step of {3}, of which the time of the state is a multiple, has no such row",
            t, next, step, made > 0 ? t / static_cast<double>(made) : step));
  }
  at_.steps = made, at_.besides = before.steps_of_any_length() + (first > 0) - made;
  changes_.push_back({t, old, step});
  return first;
}
void RunPosition::check(std::string const& checkpoint) const {
  Place const until = scene_.file.section("run").place("until");
  check_rows(at_, scene_, until);
  if (snapshots_) check_snapshots(taken_, scene_, until);
  long const rows = scene_.schedule.rows(), all = count_of_whole_run();
  bool const in_range =
      at_.rows >= 0 && at_.rows <= rows && at_.steps >= 0 && at_.steps <= all && taken_.snapshots >= 0;
  if (!in_range)
    throw FileError(fmt::format("{}: is damaged: {} rows and {} steps, where the scene has {} and {}",
                                checkpoint, at_.rows, at_.steps, rows, all));
}

}  // namespace actio::scene
