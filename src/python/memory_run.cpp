#include "python/memory_run.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "program/base/memory.hpp"
#include "program/output/hdf5_series.hpp"
#include "program/output/series_reader.hpp"
#include "program/pictures/pictures.hpp"
#include "program/registry/units.hpp"
#include "program/run/checkpoint.hpp"
#include "program/run/run_files.hpp"
#include "program/run/run_folder.hpp"

namespace actio::python {

using namespace scene;

namespace {

namespace fs = std::filesystem;

/// What a run has besides its numbers.
MemoryRun without_rows(Scene const& scene) {
  MemoryRun out;
  out.columns = {"t"};
  for (auto const& group : scene.simulation.quantities.column_groups()) {
    out.columns.insert(out.columns.end(), group.columns.begin(), group.columns.end());
    out.groups.push_back({group, unit_of(scene, group.quantity)});
  }
  out.time_unit = time_unit(scene);
  out.scene = scene.file.written();
  out.inputs = scene.file.inputs();
  out.with_snapshots = scene.snapshots && scene.simulation.snapshots;
  return out;
}

/// @throws Error  where a table of so many rows and columns, at 8 bytes a number, takes more memory than is
///                available
void check_that_it_fits(double rows, std::size_t columns) {
  double const bytes = 8 * rows * static_cast<double>(columns), available = bytes_of_machine();
  if (bytes <= available) return;
  char count[32];
  std::snprintf(count, sizeof count, "%.0f", rows);
  throw Error(
      std::string(count) + " rows of " + std::to_string(columns) + " columns at 8 bytes a number take " +
      bytes_in_words(bytes) + ", and " + bytes_in_words(available) +
      " of memory are available; fewer rows or quantities would do, or the command `actio run`, which "
      "writes as it goes");
}

/// That so many snapshots fit into the memory, and the places to which they belong.
MemorySnapshots begun(SnapshotWriter const& writer, double count) {
  std::size_t numbers = 0;
  for (auto const& field : writer.fields()) numbers += field.numbers.size();
  check_that_it_fits(count, numbers);
  MemorySnapshots out;
  out.coordinates = writer.coordinates();
  return out;
}

/// The whole of a small file; nothing where it is not there.
std::string text_of(std::string const& path) {
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

/// No more rows than a table of this size can hold: a number takes two bytes at least.
double most_rows(std::string const& folder, std::size_t columns) {
  std::error_code none;
  double const numbers = static_cast<double>(fs::file_size(folder + "/series.csv", none)) / 2;
  return none ? 0 : std::ceil(numbers / static_cast<double>(columns));
}

void refuse_what_is_no_run(std::string const& folder) {
  std::error_code none;
  auto const refuse = [&](std::string const& why) { throw SceneError({folder}, why); };
  if (!fs::exists(folder, none)) refuse("the folder of a run is expected, and there is none of that name");
  if (!fs::is_directory(folder, none)) refuse("the folder of a run is expected, and this is a file");
  if (fs::exists(folder + "/scene.toml", none)) return;
  if (fs::exists(folder + "/sweep.csv", none))
    refuse("this is the folder of a sweep; a run is in the folder of a member");
  refuse("there is no run in this folder: scene.toml is missing");
}

}  // namespace

void MemorySnapshots::add(double time, std::vector<SnapshotArray> one) {
  times.push_back(time);
  if (fields.empty()) return fields.swap(one);
  for (std::size_t k = 0; k < fields.size(); ++k)
    fields[k].numbers.insert(fields[k].numbers.end(), one[k].numbers.begin(), one[k].numbers.end());
}

MemoryRun run_in_memory(SceneFile file, std::vector<Change> const& changes, Watch watch) {
  for (auto const& change : changes) {
    if (change.drop)
      file.drop(change.text);
    else
      file.change(change.text);
  }
  Scene scene = Scene::read(std::move(file), {true, watch.stop});
  std::size_t const columns = 1 + scene.simulation.quantities.row_size();
  check_that_it_fits(static_cast<double>(scene.schedule.rows()), columns);
  MemoryRun out = without_rows(scene);
  RunOptions options;
  options.quiet = true, options.stop = std::move(watch.stop), options.watch = std::move(watch.see);
  if (out.with_snapshots) {
    out.snapshots = begun(*scene.simulation.snapshots, static_cast<double>(scene.snapshots->rows()));
    options.snapshot = [&](double time) { out.snapshots.add(time, scene.simulation.snapshots->fields()); };
  }
  out.report = scene::run_in_memory(scene, out.table, options);
  // One that ended early has set aside more than it took.
  if (out.table.size() < out.table.capacity() / 2) out.table.shrink_to_fit();
  out.summary = out.report.summary;
  return out;
}

MemoryRun load_run(std::string const& folder) {
  refuse_what_is_no_run(folder);
  Scene const scene = Scene::read(SceneFile::read(folder + "/scene.toml"));
  MemoryRun out = without_rows(scene);
  auto const groups = scene.simulation.quantities.column_groups();
  double const all = static_cast<double>(scene.schedule.rows());
  double const rows = std::min(most_rows(folder, out.columns.size()), all);
  check_that_it_fits(rows, out.columns.size());
  out.table.reserve(static_cast<std::size_t>(rows) * out.columns.size());
  auto const reader = read_series(folder, groups);
  std::vector<double> row(out.columns.size());
  while (reader->next(row)) out.table.insert(out.table.end(), row.begin(), row.end());
  out.summary = text_of(folder + "/summary.json");
  return out;
}

MemorySnapshots load_snapshots(std::string const& folder) {
  refuse_what_is_no_run(folder);
  Scene const scene = Scene::read(SceneFile::read(folder + "/scene.toml"));
  if (!scene.snapshots || !scene.simulation.snapshots) return {};
  std::vector<double> times;
  auto const reader = read_csv_series(folder + "/" + times_of_snapshots, {"snapshot", "t"});
  for (std::vector<double> row(2); reader->next(row);) times.push_back(row[1]);
  SnapshotWriter const& writer = *scene.simulation.snapshots;
  MemorySnapshots out = begun(writer, static_cast<double>(times.size()));
  for (double const time : times)
    out.add(time, writer.fields_in(folder, static_cast<long>(out.times.size())));
  return out;
}

void save_run(std::string const& text, std::span<double const> table, std::string const& summary,
              std::string const& folder, bool pictures) {
  Scene const scene = Scene::read(SceneFile::parse(text, folder + "/scene.toml"));
  std::size_t const width = 1 + scene.simulation.quantities.row_size();
  RunFolder const made = RunFolder::create(folder, false, files_of_run(scene));
  SeriesHead const head = series_head(scene, text, static_cast<long>(table.size() / width));
  {
    auto const series = open_series(folder, head, false);
    for (std::size_t at = 0; at + width <= table.size(); at += width) series->add(table.subspan(at, width));
    series->sync();
  }
  if (std::find(scene.formats.begin(), scene.formats.end(), "hdf5") != scene.formats.end())
    make_hdf5_series(folder, head, true);
  write_whole_file(folder + "/summary.json", summary);
  write_whole_file(folder + "/scene.toml", text);
  if (pictures) draw_pictures(scene, folder, true);
}

}  // namespace actio::python
