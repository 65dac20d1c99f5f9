#include "actio/scene/run.hpp"

#include <fmt/format.h>

#include <chrono>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <optional>

#include "actio/scene/checkpoint.hpp"
#include "actio/scene/error_estimate.hpp"
#include "actio/scene/memory_series.hpp"
#include "actio/scene/progress.hpp"
#include "actio/scene/rhythm.hpp"
#include "actio/scene/units.hpp"

namespace actio::scene {
namespace {

using Clock = Rhythm::Clock;

/// How far a run is: the head of its checkpoint.
struct Progression {
  long steps = 0, rows = 0;
  double seconds = 0;  // of all processes
};

/// The run of one scene.
class Run {
 public:
  Run(Scene& scene, std::string const& folder, bool resume, RunOptions const& options)
      : scene_(scene), simulation_(scene.simulation), folder_(folder), resumed_(resume), options_(options), drift_(simulation_.quantities.conserved()),
        error_(simulation_), progress_(options.quiet, simulation_.exact ? "rows" : "steps"), written_(scene.file.written()) {
    if (!simulation_.exact) steps_to_.emplace(scene.schedule, simulation_.step, scene.file.section("method"));
    row_.resize(1 + simulation_.quantities.row_size());
    if (in_memory()) return;
    if (!resume) write_whole_file(folder + "/scene.toml", written_);
    SeriesHead head{scene.title, scene.system->name, written_, simulation_.quantities.column_groups(),
                    scene.schedule.rows()};
    for (auto& group : head.groups) group.quantity.unit = plain_unit_of(scene, group.quantity);
    if (std::string const unit = time_unit(scene); !unit.empty()) head.time_unit = unit;
    for (auto const& format : scene.formats) series_.push_back(open_series(folder, format, head, resume));
    if (resume) restore();
  }

  /// Into a table in memory, without a folder.
  Run(Scene& scene, std::vector<double>& table, RunOptions const& options) : Run(scene, "", false, options) {
    table.reserve(static_cast<std::size_t>(scene.schedule.rows()) * row_.size());
    series_.push_back(memory_series(table));
  }

  RunReport go() {
    RunReport report;
    try {
      start();
      if (!go_on()) report.ending = Ending::interrupted, report.message = fmt::format("interrupted, with {} of {} rows", at_.rows, scene_.schedule.rows());
    } catch (FileError const& error) {
      report.ending = Ending::file_failed, report.message = error.what();
    } catch (NumericsError const& error) {
      report.ending = Ending::numerics_failed, report.message = error.what();
    } catch (std::exception const& error) {
      report.ending = Ending::numerics_failed;
      report.message = fmt::format("{}: after t = {}: {}", scene_.file.section("method").place("step").text(), time_now(), error.what());
    }
    finish(report);
    return report;
  }

 private:
  bool in_memory() const { return folder_.empty(); }

  /// The first checkpoint, before the first step; and what the drift is measured from, where there is no row at t = 0.
  void start() {
    if (resumed_) {
      std::error_code none;
      std::filesystem::remove(folder_ + "/summary.json", none);  // how the part before ended
    } else {
      if (!drift_.empty() && scene_.schedule.time(0) > 0) {
        simulation_.quantities.evaluate(std::span(row_).subspan(1));
        drift_.see(std::span(row_).subspan(1), simulation_.quantities.natural_units());
      }
      checkpoint();
    }
    progress_.start(fraction(), count());
  }

  /// @return false where it was asked to stop before its last row
  bool go_on() {
    while (at_.rows < scene_.schedule.rows()) {
      if (options_.stop()) return false;
      double const t = scene_.schedule.time(at_.rows);
      if (t > 0 && !simulation_.failure.empty()) throw NumericsError(simulation_.failure);
      if (simulation_.exact) simulation_.motion->go_to(t);
      else if (!advance_to((*steps_to_)(at_.rows))) return false;
      else simulation_.motion->look_ahead(steps_to_->beyond(at_.rows));
      write_row(t);
      if (rhythm_.due()) look_up();
    }
    return true;
  }

  /// @return false where it was asked to stop on the way
  bool advance_to(long target) {
    long const at_once = simulation_.steps_at_once;
    while (at_.steps < target) {
      // Pieces end at multiples of their length, whatever the load of the machine: the digits are those of an unbroken run.
      long const piece = std::min(target - at_.steps, at_once - at_.steps % at_once);
      simulation_.motion->advance(piece);
      at_.steps += piece;
      error_.follow(at_.steps);
      if (at_.steps == target) break;
      if (options_.stop()) return false;
      if (piece == at_once || rhythm_.due()) look_up();
    }
    return true;
  }

  void write_row(double t) {
    row_[0] = t;
    std::span<double> const values = std::span(row_).subspan(1);
    simulation_.quantities.evaluate(values);
    double nothing = 0;
    for (double const x : values) nothing += 0 * x;
    if (nothing != 0) refuse_row(t);
    drift_.see(values, simulation_.quantities.natural_units());
    error_.see(at_.rows, t, at_.steps, at_.rows + 1 == scene_.schedule.rows());
    for (auto& series : series_) series->add(row_);
    ++at_.rows, wrote_ = true;
  }
  /// A NaN or an infinity in a row.
  [[noreturn]] void refuse_row(double t) const {
    auto const columns = simulation_.quantities.columns();
    std::size_t k = 1;
    while (k < columns.size() && std::isfinite(row_[k])) ++k;
    throw NumericsError(fmt::format("{}: {} is {} at t = {}, where a finite number is needed", scene_.file.section("method").place("step").text(), columns[k - 1], row_[k], t));
  }

  /// From time to time: progress, rows for whoever watches, and a checkpoint.
  void look_up() {
    auto const now = rhythm_.look();
    if (now - last_flush_ >= std::chrono::milliseconds(500)) {
      for (auto& series : series_) series->flush();
      last_flush_ = now;
    }
    progress_.show(now, fraction(), count(), drift_.empty() ? std::nullopt : std::optional(drift_.worst()));
    if (now - last_checkpoint_ >= std::chrono::duration<double>(options_.checkpoint_interval)) checkpoint();
  }

  void checkpoint() {
    if (in_memory()) return;
    for (auto& series : series_) series->sync();
    Memory memory;
    remember(memory);
    write_checkpoint(folder_ + "/checkpoint", written_, memory.bytes());
    last_checkpoint_ = Clock::now();
  }
  void remember(Memory& memory) {
    Progression place{at_.steps, at_.rows, seconds()};
    memory(place);
    if (memory.reading()) at_ = place;
    simulation_.motion->remember(memory);
    simulation_.quantities.remember(memory);
    drift_.remember(memory);
    error_.remember(memory);
    for (auto& series : series_) series->remember(memory);
    memory.end();
  }
  void restore() {
    std::string const path = folder_ + "/checkpoint";
    Memory memory(read_checkpoint(path, written_));
    try {
      remember(memory);
    } catch (FileError const&) {
      throw;
    } catch (Error const& error) {
      throw FileError(path + ": is damaged: " + error.what());
    }
    bool const in_range = at_.rows >= 0 && at_.rows <= scene_.schedule.rows() && at_.steps >= 0 && at_.steps <= all();
    if (!in_range) throw FileError(fmt::format("{}: is damaged: {} rows and {} steps, where the scene has {} and {}", path, at_.rows, at_.steps, scene_.schedule.rows(), all()));
  }

  /// Writes what is left to write. The first thing that went wrong is told, but a file that fails last decides the status.
  void finish(RunReport& report) {
    auto const attempt = [&](auto const& write) {
      try {
        write();
      } catch (FileError const& error) {
        if (report.ending == Ending::file_failed) return;
        report.message += (report.message.empty() ? "" : "; ") + std::string(error.what());
        report.ending = Ending::file_failed;
      }
    };
    // What is in memory goes with the files only while none of them has failed, and while the last steps were whole: otherwise the checkpoint before stands.
    bool const whole = report.ending == Ending::done || report.ending == Ending::interrupted;
    for (auto& series : series_) attempt([&] { series->flush(); });
    if (whole && report.ending != Ending::file_failed) attempt([&] { checkpoint(); });
    if (report.ending == Ending::done) progress_.show(Clock::now(), 1, count(), drift_.empty() ? std::nullopt : std::optional(drift_.worst()));
    report.steps = at_.steps, report.rows = at_.rows, report.seconds = seconds(), report.drift = drift_.entries();
    report.error = error_.entries(), report.error_how = error_.how();
    if (wrote_) report.last_row = row_;
    report.summary = summary_json(scene_, report);
    if (!in_memory()) attempt([&] { write_whole_file(folder_ + "/summary.json", report.summary); });
  }

  /// Steps, or rows where there are no steps: so far, and of the whole run.
  long count() const { return simulation_.exact ? at_.rows : at_.steps; }
  long all() const { return simulation_.exact ? scene_.schedule.rows() : (*steps_to_)(scene_.schedule.rows() - 1); }
  double fraction() const { return all() > 0 ? static_cast<double>(count()) / static_cast<double>(all()) : 1; }
  double time_now() const { return simulation_.exact ? (at_.rows > 0 ? scene_.schedule.time(at_.rows - 1) : 0) : static_cast<double>(at_.steps) * simulation_.step; }
  double seconds() const { return at_.seconds + std::chrono::duration<double>(Clock::now() - began_).count(); }

  Scene& scene_;
  Simulation& simulation_;
  std::string folder_;
  bool resumed_;
  RunOptions options_;
  Drift drift_;
  ErrorEstimate error_;
  Progress progress_;
  Rhythm rhythm_;
  std::string written_;
  std::optional<StepsToRows> steps_to_;
  std::vector<std::unique_ptr<Series>> series_;
  std::vector<double> row_;
  Progression at_;            // its seconds: those of the processes before
  bool wrote_ = false;  // a row, in this process
  Clock::time_point began_ = Clock::now(), last_flush_ = began_, last_checkpoint_ = began_;
};

}  // namespace

RunReport run_scene(Scene& scene, std::string const& folder, bool resume, RunOptions const& options) { return Run(scene, folder, resume, options).go(); }
RunReport run_in_memory(Scene& scene, std::vector<double>& table, RunOptions const& options) { return Run(scene, table, options).go(); }

bool run_is_finished(Scene const& scene, std::string const& folder) {
  std::string const path = folder + "/checkpoint";
  Memory memory(read_checkpoint(path, scene.file.written()));
  Progression place;
  if (memory.bytes().size() < sizeof place) throw FileError(path + ": is damaged: it ends too early");
  memory(place);
  return place.rows == scene.schedule.rows() && std::filesystem::exists(folder + "/summary.json");
}

double checkpoint_interval() {
  char const* const text = std::getenv("ACTIO_CHECKPOINT_SECONDS");
  if (!text) return RunOptions{}.checkpoint_interval;
  char* end = nullptr;
  double const seconds = std::strtod(text, &end);
  if (end == text || *end || !(seconds >= 0)) throw SceneError({"ACTIO_CHECKPOINT_SECONDS"}, fmt::format("a number of seconds is expected, found '{}'", text));
  return seconds;
}

}  // namespace actio::scene
