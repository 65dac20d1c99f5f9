#include "actio/scene/run.hpp"

#include <chrono>
#include <optional>

#include "actio/scene/checkpoint.hpp"
#include "actio/scene/interrupt.hpp"
#include "actio/scene/progress.hpp"

namespace actio::scene {
namespace {

using Clock = std::chrono::steady_clock;

/// The run of one scene.
class Run {
 public:
  Run(Scene& scene, std::string const& folder, bool resume, RunOptions const& options)
      : scene_(scene), folder_(folder), options_(options), drift_(scene.simulation.quantities.conserved()), progress_(options.quiet), written_(scene.file.written()) {
    if (!scene.simulation.exact) steps_to_.emplace(scene.schedule, scene.simulation.step, scene.file.section("method"));
    row_.resize(1 + scene.simulation.quantities.row_size());
    if (!resume) write_whole_file(folder + "/scene.toml", written_);
    SeriesHead const head{scene.title, scene.system->name, written_, scene.simulation.quantities.column_groups(), scene.schedule.rows()};
    for (auto const& format : scene.formats) series_.push_back(open_series(folder, format, head, resume));
    if (resume) {
      Memory memory(read_checkpoint(folder + "/checkpoint", written_));
      remember(memory);
    }
  }

  RunReport go() {
    RunReport report;
    try {
      while (next_row_ < scene_.schedule.rows() && !interrupted()) {
        double const t = scene_.schedule.time(next_row_);
        if (scene_.simulation.exact) scene_.simulation.motion->go_to(t);
        else if (!advance_to((*steps_to_)(next_row_))) break;
        write_row(t);
        if (scene_.simulation.exact ? next_row_ % 64 == 0 : since_look_ == 0) look_up();
      }
      if (next_row_ < scene_.schedule.rows()) report.ending = Ending::interrupted, report.message = "interrupted";
    } catch (FileError const& error) {
      report.ending = Ending::file_failed, report.message = error.what();
    } catch (Error const& error) {
      report.ending = Ending::numerics_failed, report.message = scene_.file.section("method").place("step").text() + ": " + error.what();
    }
    try {
      finish(report);
    } catch (FileError const& error) {
      report.ending = Ending::file_failed, report.message = error.what();
    }
    return report;
  }

 private:
  /// @return false where the run was interrupted on the way
  bool advance_to(long target) {
    long const at_once = scene_.simulation.steps_at_once;
    while (done_ < target) {
      // Pieces end at multiples of their length, whatever the load of the machine: the digits are those of an unbroken run.
      long const piece = std::min(target - done_, at_once - done_ % at_once);
      scene_.simulation.motion->advance(piece);
      done_ += piece;
      since_look_ += piece;
      if (since_look_ >= at_once) {
        since_look_ = 0;
        if (interrupted()) return done_ >= target;
        look_up();
      }
    }
    return true;
  }

  void write_row(double t) {
    row_[0] = t;
    std::span<double> const values = std::span(row_).subspan(1);
    scene_.simulation.quantities.evaluate(values);
    drift_.see(values);
    for (auto& series : series_) series->add(row_);
    ++next_row_;
  }

  /// From time to time: progress, rows for whoever watches, and a checkpoint.
  void look_up() {
    auto const now = Clock::now();
    if (now - last_flush_ >= std::chrono::milliseconds(500)) {
      for (auto& series : series_) series->flush();
      last_flush_ = now;
    }
    if (now - last_checkpoint_ >= std::chrono::duration<double>(options_.checkpoint_interval)) checkpoint();
    progress_.show(scene_.simulation.exact ? static_cast<double>(next_row_) / static_cast<double>(scene_.schedule.rows()) : static_cast<double>(done_) * scene_.simulation.step / scene_.schedule.until(),
                   done_, drift_.worst());
  }

  void checkpoint() {
    for (auto& series : series_) series->sync();
    Memory memory;
    remember(memory);
    write_checkpoint(folder_ + "/checkpoint", written_, memory.bytes());
    last_checkpoint_ = Clock::now();
  }
  void remember(Memory& memory) {
    memory(done_, next_row_, since_look_);
    scene_.simulation.motion->remember(memory);
    drift_.remember(memory);
    for (auto& series : series_) series->remember(memory);
  }

  void finish(RunReport& report) {
    for (auto& series : series_) series->flush();
    report.steps = done_, report.rows = next_row_;
    report.seconds = std::chrono::duration<double>(Clock::now() - began_).count();
    checkpoint();
    write_whole_file(folder_ + "/summary.json", summary_json(scene_, report, drift_));
  }

  Scene& scene_;
  std::string folder_;
  RunOptions options_;
  Drift drift_;
  Progress progress_;
  std::string written_;
  std::optional<StepsToRows> steps_to_;
  std::vector<std::unique_ptr<Series>> series_;
  std::vector<double> row_;
  long done_ = 0, next_row_ = 0, since_look_ = 0;
  Clock::time_point began_ = Clock::now(), last_flush_ = began_, last_checkpoint_ = began_;
};

}  // namespace

RunReport run_scene(Scene& scene, std::string const& folder, bool resume, RunOptions const& options) { return Run(scene, folder, resume, options).go(); }

}  // namespace actio::scene
