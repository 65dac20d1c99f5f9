#include "program/run/run.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <optional>

#include "program/base/poll_interval.hpp"
#include "program/base/progress.hpp"
#include "program/base/whole_file.hpp"
#include "program/registry/error_estimate.hpp"
#include "program/run/change_of_step.hpp"
#include "program/run/checkpoint.hpp"
#include "program/run/exports.hpp"
#include "program/run/run_output.hpp"
#include "program/run/run_position.hpp"

namespace actio::scene {
namespace {

using Clock = PollInterval::Clock;

/// The run of one scene.
class Run {
 public:
  /// @param before  the scene with the steps up to the checkpoint, where they had another length
  Run(Scene& scene, std::string const& folder, bool resume, RunOptions const& options,
      Scene* before = nullptr)
      : scene_(scene),
        simulation_(scene.simulation),
        before_(before),
        folder_(folder),
        resumed_(resume),
        options_(options),
        drift_(simulation_.quantities.conserved()),
        error_(simulation_),
        progress_(options.quiet, simulation_.exact ? "rows" : "steps"),
        written_(scene.file.written()),
        determined_(folder.empty() ? "" : what_determines(scene.file)),
        position_(scene, scene.snapshots && simulation_.snapshots && (!folder.empty() || options.snapshot)) {
    row_.resize(1 + simulation_.quantities.row_size());
    if (!in_memory() && !resume) write_whole_file(folder + "/scene.toml", written_, options_.durable);
    output_.emplace(scene, folder, resume, position_.with_snapshots(), options.snapshot);
    if (resume) restore();
    for (auto const& change : position_.step_changes())
      simulation_.remarks.push_back("step: " + in_words(change));
    output_->begin_snapshots(position_.snapshots());
  }

  /// Into a table in memory, without a folder.
  Run(Scene& scene, std::vector<double>& table, RunOptions const& options) : Run(scene, "", false, options) {
    output_->add_table(table, row_.size());
  }

  RunReport go() {
    RunReport report;
    try {
      start();
      if (!go_on())
        report.ending = Ending::interrupted,
        report.message =
            fmt::format("interrupted, with {} of {} rows", position_.rows(), scene_.schedule.rows());
    } catch (FileError const& error) {
      report.ending = Ending::file_failed, report.message = error.what();
    } catch (NumericsError const& error) {
      report.ending = Ending::numerics_failed, report.message = error.what();
    } catch (std::exception const& error) {
      report.ending = Ending::numerics_failed;
      report.message = fmt::format("{}: after t = {}: {}", scene_.file.section("method").place("step").text(),
                                   position_.time(), error.what());
    }
    finish(report);
    return report;
  }

 private:
  bool in_memory() const { return folder_.empty(); }

  /// The first checkpoint, before the first step; and what the drift is measured from, where there is no row
  /// at t = 0.
  void start() {
    if (resumed_) {
      std::error_code none;
      std::filesystem::remove(folder_ + "/summary.json", none);  // how the part before ended
      if (before_) {
        // Both belong together: what comes between them is put right by `finish_change_of_step`.
        WholeFile scene(folder_ + "/scene.toml");
        scene.write(with_remarks(written_, position_.step_changes()));
        checkpoint();
        scene.name(options_.durable);
      }
    } else {
      if (!drift_.empty() && scene_.schedule.time(0) > 0) {
        simulation_.quantities.evaluate(std::span(row_).subspan(1));
        drift_.see(std::span(row_).subspan(1), simulation_.quantities.natural_units());
      }
      if (options_.durable) checkpoint();
    }
    progress_.start(position_.fraction(), position_.count());
  }

  /// @return false where it was asked to stop before its last row
  bool go_on() {
    while (!position_.at_end()) {
      if (options_.stop()) return false;
      Next const next = position_.next();
      double const t = position_.time_of(next);
      if (t > 0 && !simulation_.failure.empty()) throw NumericsError(simulation_.failure);
      if (simulation_.exact)
        simulation_.motion->go_to(t);
      else if (!advance_to(position_.steps_to(next)))
        return false;
      else
        simulation_.motion->look_ahead(position_.beyond_steps(next));
      if (next == Next::row)
        write_row(t);
      else
        output_->take_snapshot(position_.snapshots(), t, options_.durable), position_.wrote_snapshot(t);
      if (poll_.due()) look_up();
    }
    return true;
  }

  /// @return false where it was asked to stop on the way
  bool advance_to(long target) {
    long const at_once = simulation_.steps_at_once;
    while (position_.steps() < target) {
      // Pieces end at multiples of their length, whatever the load of the machine: the digits are those of an
      // unbroken run.
      long const piece = std::min(target - position_.steps(), at_once - position_.steps() % at_once);
      simulation_.motion->advance(piece);
      position_.made(piece);
      error_.follow(position_.steps());
      if (position_.steps() == target) break;
      if (options_.stop()) return false;
      if (piece == at_once || poll_.due()) look_up();
    }
    return true;
  }

  void write_row(double t) {
    row_[0] = t;
    std::span<double> const values = std::span(row_).subspan(1);
    simulation_.quantities.evaluate(values);
    double nothing = 0;
    for (double& x : values) {
      nothing += 0 * x;
      if (x == 0) x = 0;  // and not -0
    }
    if (nothing != 0) refuse_row(t);
    drift_.see(values, simulation_.quantities.natural_units());
    long const row = position_.rows();
    error_.see(row, t, position_.steps(), row + 1 == scene_.schedule.rows());
    output_->add_row(row_);
    position_.wrote_row(t), wrote_ = true;
  }
  /// A NaN or an infinity in a row.
  [[noreturn]] void refuse_row(double t) const {
    auto const columns = simulation_.quantities.columns();
    std::size_t k = 1;
    while (k < columns.size() && std::isfinite(row_[k])) ++k;
    throw NumericsError(fmt::format("{}: {} is {} at t = {}, where a finite number is needed",
                                    scene_.file.section("method").place("step").text(), columns[k - 1],
                                    std::isnan(row_[k]) ? std::abs(row_[k]) : row_[k], t));
  }

  /// From time to time: progress, rows for the watcher, and a checkpoint.
  void look_up() {
    auto const now = poll_.look();
    if (now - last_flush_ >= std::chrono::milliseconds(500)) {
      output_->flush(position_.snapshots(), false);
      last_flush_ = now;
    }
    progress_.show(now, position_.fraction(), position_.count(),
                   drift_.empty() ? std::nullopt : std::optional(drift_.worst()));
    if (options_.watch) options_.watch(position_.fraction(), position_.time());
    if (now - last_checkpoint_ < std::chrono::duration<double>(options_.checkpoint_interval)) return;
    checkpoint();
    if (in_memory() || Clock::now() < next_exports_) return;
    auto const began = Clock::now();
    try {
      export_files(false);
    } catch (FileError const&) {
      // At the end they are made once more, and it is told if they still cannot be.
    }
    next_exports_ = Clock::now() + std::max(interval_of_exports(), 50 * (Clock::now() - began));
  }

  /// Files of other formats are made of the plain ones: thirty checkpoints apart or more, fifty times as long
  /// as it takes.
  void export_files(bool at_end) {
    make_exports(scene_, folder_, scene_.formats, {options_.durable, at_end});
  }
  Clock::duration interval_of_exports() const {
    return std::chrono::duration_cast<Clock::duration>(
        std::chrono::duration<double>(30 * options_.checkpoint_interval));
  }

  void checkpoint() {
    if (in_memory()) return;
    std::string const scene = folder_ + "/scene.toml";
    if (std::error_code none; !std::filesystem::exists(scene, none))
      write_whole_file(scene, with_remarks(written_, position_.step_changes()), options_.durable);
    output_->each_table([&](Series& table) { options_.durable ? table.sync() : table.flush(); });
    CheckpointStream stream;
    remember(stream);
    write_checkpoint(folder_ + "/checkpoint", determined_, stream.bytes(), options_.durable);
    last_checkpoint_ = Clock::now();
  }
  void remember(CheckpointStream& stream) { remember(stream, scene_, position_, error_); }
  void remember(CheckpointStream& stream, Scene& scene, RunPosition& position, ErrorEstimate& error) {
    InputFiles files = scene.file.inputs();
    scene::remember(stream, files);
    if (stream.reading()) refuse_changed(files, scene.file.inputs());
    position.remember(stream);
    if (position.with_snapshots()) stream(row_);
    scene.simulation.motion->remember(stream);
    simulation_.quantities.remember(stream);
    drift_.remember(stream);
    error.remember(stream);
    output_->each_table([&](Series& table) { table.remember(stream); });
    stream.end();
  }
  void restore() {
    std::string const path = folder_ + "/checkpoint";
    Scene& scene = before_ ? *before_ : scene_;
    RunPosition position(scene, position_.with_snapshots());
    ErrorEstimate estimate(scene.simulation);
    CheckpointStream stream(read_checkpoint(path, what_determines(scene.file)));
    try {
      remember(stream, scene, before_ ? position : position_, before_ ? estimate : error_);
    } catch (FileError const&) {
      throw;
    } catch (SceneError const&) {
      throw;
    } catch (Error const& error) {
      throw FileError(path + ": is damaged: " + error.what());
    }
    if (before_) {
      double const first = position_.change_step(position);
      hand_over(*before_->simulation.motion, *simulation_.motion, first, simulation_.step, position_.steps());
    }
    position_.check(path);
  }

  /// Writes what is left to write. The first thing that went wrong is told, but a file that fails last
  /// decides the status.
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
    // What is in memory goes with the files only while none of them has failed, and while the last steps were
    // whole: otherwise the checkpoint before stands.
    bool const whole = report.ending == Ending::done || report.ending == Ending::interrupted;
    output_->each_table([&](Series& table) { attempt([&] { table.flush(); }); });
    attempt([&] { output_->show_snapshots(position_.snapshots(), true); });
    if (whole && report.ending != Ending::file_failed) attempt([&] { checkpoint(); });
    if (report.ending == Ending::done)
      progress_.show(Clock::now(), 1, position_.count(),
                     drift_.empty() ? std::nullopt : std::optional(drift_.worst()));
    report.steps = position_.steps_of_any_length(), report.rows = position_.rows();
    report.snapshots = position_.snapshots(), report.seconds = position_.seconds();
    report.drift = drift_.entries();
    report.error = error_.entries(), report.error_how = error_.how();
    if (scene_.accuracy && report.ending == Ending::done) compare_with_accuracy(*scene_.accuracy);
    report.step_changes = position_.step_changes();
    if (!report.step_changes.empty())
      report.error.clear(), report.error_how = fmt::format("not estimated: the step was changed at t = {}",
                                                           report.step_changes.front().time);
    // A run with snapshots may be beyond its last row, and has it from its checkpoint.
    if (!wrote_ && report.ending == Ending::done && !position_.with_snapshots()) evaluate_last_row();
    if (wrote_ || report.ending == Ending::done) report.last_row = row_;
    if (whole) report.hash = hash_of_state(report.last_row);
    // All files are made before the summary says that the run is finished: after a kill in between, `resume`
    // makes them.
    output_->close();
    if (!in_memory() && report.ending != Ending::file_failed) attempt([&] { export_files(true); });
    report.summary = summary_json(scene_, report);
    if (!in_memory())
      attempt([&] { write_whole_file(folder_ + "/summary.json", report.summary, options_.durable); });
  }

  /// Of all that the next step depends on, or of the last row where there are no steps (FNV-1a, 64 bits).
  std::string hash_of_state(std::vector<double> const& last_row) {
    CheckpointStream stream;
    simulation_.motion->save_state(stream);
    std::uint64_t hash = 14695981039346656037u;
    auto const add = [&](std::span<std::byte const> bytes) {
      for (std::byte const one : bytes) hash = (hash ^ static_cast<std::uint64_t>(one)) * 1099511628211u;
    };
    add(simulation_.exact ? std::as_bytes(std::span(last_row)) : std::as_bytes(std::span(stream.bytes())));
    return fmt::format("{:016x}", hash);
  }

  /// Where the error of the run is larger than was asked, or not told.
  void compare_with_accuracy(double accuracy) {
    auto const worst = error_.worst();
    if (!worst || (worst->told() && worst->error <= accuracy)) return;
    simulation_.remarks.push_back(
        fmt::format("accuracy: {} was asked, and the error of the {} is {}", accuracy, worst->name,
                    worst->told() ? fmt::format("estimated as {:.1e}{}", worst->error, worst->unit)
                                  : "not told: " + worst->said));
  }

  /// Of a run whose rows were all there when this process began.
  void evaluate_last_row() {
    long const last = scene_.schedule.rows() - 1;
    row_[0] = scene_.schedule.time(last);
    if (simulation_.exact)
      simulation_.motion->go_to(row_[0]);
    else
      simulation_.motion->look_ahead(position_.beyond_steps_to_last_row());
    simulation_.quantities.evaluate(std::span(row_).subspan(1));
  }

  Scene& scene_;
  Simulation& simulation_;
  Scene* before_;
  std::string folder_;
  bool resumed_;
  RunOptions options_;
  Drift drift_;
  ErrorEstimate error_;
  Progress progress_;
  PollInterval poll_;
  std::string written_, determined_;
  RunPosition position_;
  std::optional<RunOutput> output_;
  std::vector<double> row_;
  bool wrote_ = false;  // a row, in this process
  Clock::time_point last_flush_ = Clock::now(), last_checkpoint_ = last_flush_,
                    next_exports_ = last_flush_ + interval_of_exports();
};

}  // namespace

void refuse_without_step(Scene const& scene) {
  bool const stays = scene.schedule.time(scene.schedule.rows() - 1) == 0 &&
                     (!scene.snapshots || scene.snapshots->time(scene.snapshots->rows() - 1) == 0);
  if (!stays && !scene.simulation.failure.empty()) throw NumericsError(scene.simulation.failure);
}

RunReport run_scene(Scene& scene, std::string const& folder, bool resume, RunOptions const& options) {
  return Run(scene, folder, resume, options).go();
}
RunReport run_with_other_step(Scene& scene, Scene& before, std::string const& folder,
                              RunOptions const& options) {
  return Run(scene, folder, true, options, &before).go();
}
RunReport run_in_memory(Scene& scene, std::vector<double>& table, RunOptions const& options) {
  return Run(scene, table, options).go();
}

}  // namespace actio::scene
