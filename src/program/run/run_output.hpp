// What a run writes as it goes: the tables of its rows, and its snapshots.
#pragma once

#include <array>

#include "program/base/own_files.hpp"
#include "program/output/memory_series.hpp"
#include "program/run/run.hpp"
#include "program/run/run_files.hpp"

namespace actio::scene {

/// Tables and snapshots of one run, in its folder; or in memory, where there is no folder.
class RunOutput {
 public:
  /// @param scene      outlives it
  /// @param resume     whether the files are there, and will be cut back by `remember`
  /// @param snapshots  whether there are any
  /// @param told       of snapshots in memory
  /// @throws SceneError, FileError
  RunOutput(Scene& scene, std::string folder, bool resume, bool snapshots, std::function<void(double)> told)
      : scene_(scene), folder_(std::move(folder)), with_snapshots_(snapshots), told_(std::move(told)) {
    if (in_memory()) return;
    SeriesHead const head = series_head(scene, scene.file.written(), scene.schedule.rows());
    series_.push_back(open_series(folder_, head, resume));
    if (!snapshots) return;
    OwnFiles(folder_).claim(files_of_snapshots(scene));
    times_ = csv_series(folder_ + "/" + times_of_snapshots, {"snapshot", "t"}, resume);
  }
  /// Rows go into this table, too.
  void add_table(std::vector<double>& table, std::size_t width) {
    series_.push_back(memory_series(table, static_cast<std::size_t>(scene_.schedule.rows()), width));
  }

  /// The first so many snapshots are there, or it is remarked that they are not; the next one will be taken.
  void begin_snapshots(long taken) {
    if (in_memory() || !with_snapshots_) return;
    auto const missing = missing_snapshots(scene_, folder_, taken);
    if (missing.count > 0) scene_.simulation.remarks.push_back(missing.told);
    missing_ = missing.count;
  }

  /// A row more, for all tables.
  void add_row(std::span<double const> row) {
    for (auto& series : series_) series->add(row);
  }
  /// A file that was not written whole is not told of.
  void take_snapshot(long number, double t, bool durable) {
    if (in_memory()) return told_(t);
    scene_.simulation.snapshots->write(folder_, number, t, durable);
    times_->add(std::array{static_cast<double>(number), t});
    times_->flush();
  }

  /// Rows and snapshots so far are in their files, for others to see, and these are there.
  /// @param taken    how many snapshots there are
  /// @param at_once  all of them; otherwise as many as take little time
  /// @throws FileError
  void flush(long taken, bool at_once) {
    each_table([](Series& table) { table.flush(); });
    show_snapshots(taken, at_once);
  }
  /// Of the snapshots alone.
  void show_snapshots(long taken, bool at_once) {
    if (in_memory() || !with_snapshots_) return;
    constexpr long few = 1000;  // are looked for in less than a hundredth of the time
    if (!at_once && taken > few) return;
    auto const missing = missing_snapshots(scene_, folder_, taken);
    if (missing.count > missing_) throw FileError(missing.told);
  }
  /// `act(table)` for each table.
  template <class Act>
  void each_table(Act const& act) {
    for (auto& series : series_) act(*series);
    if (times_) act(*times_);
  }
  /// Nothing is written any more.
  void close() { series_.clear(), times_.reset(); }

 private:
  bool in_memory() const { return folder_.empty(); }

  Scene& scene_;
  std::string folder_;
  bool with_snapshots_;
  std::function<void(double)> told_;
  std::vector<std::unique_ptr<Series>> series_;
  std::unique_ptr<Series> times_;  // of the snapshots
  std::size_t missing_ = 0;        // files of snapshots that were not there any more at the start
};

}  // namespace actio::scene
