#include "program/run/run_files.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <filesystem>

#include "program/registry/units.hpp"
#include "program/run/exports.hpp"
#include "program/run/run.hpp"

namespace actio::scene {

std::vector<std::string> files_of_snapshots(Scene const& scene) {
  std::vector<std::string> out{times_of_snapshots};
  SnapshotWriter const& writer = *scene.simulation.snapshots;
  for (long k = 0; k < scene.snapshots->rows(); ++k)
    for (auto& name : writer.files(k)) out.push_back(name), out.push_back(std::move(name) + ".part");
  return out;
}

Missing missing_snapshots(Scene const& scene, std::string const& folder, long taken) {
  constexpr std::size_t most = 3;
  std::vector<std::string> missing;
  std::size_t count = 0;
  auto const look_for = [&](std::string& name) {
    if (std::error_code none; !std::filesystem::exists(folder + "/" + name, none) && ++count <= most)
      missing.push_back(std::move(name));
  };
  SnapshotWriter const& writer = *scene.simulation.snapshots;
  for (long k = 0; k < taken; ++k)
    for (auto& name : writer.files(k)) look_for(name);
  if (count == 0) return {};
  return {count, fmt::format("{}{} {} not in {} any more; a run of the scene from its start writes {} again",
                             fmt::join(missing, ", "),
                             count > most ? fmt::format(" and {} others", count - most) : "",
                             count == 1 ? "is" : "are", folder, count == 1 ? "it" : "them")};
}

SeriesHead series_head(Scene const& scene, std::string const& written, long rows) {
  SeriesHead head{scene.title, scene.system->name, written, scene.simulation.quantities.column_groups(),
                  rows};
  for (auto& group : head.groups) group.quantity.unit = plain_unit_of(scene, group.quantity);
  if (std::string const unit = time_unit(scene); !unit.empty()) head.time_unit = unit;
  return head;
}

std::vector<std::string> files_of_run(Scene const& scene) {
  std::vector<std::string> out{"scene.toml",   "scene.toml.part",   "checkpoint", "checkpoint.part",
                               "summary.json", "summary.json.part", "series.csv"};
  if (scene.snapshots && scene.simulation.snapshots)
    for (auto& name : files_of_snapshots(scene)) out.push_back(std::move(name));
  for (auto const& format : scene.formats)
    for (auto& name : files_of_export(scene, format, scene.snapshots ? scene.snapshots->rows() : 0))
      out.push_back(name), out.push_back(std::move(name) + ".part");
  return out;
}

}  // namespace actio::scene
