#include "actio/scene/progression.hpp"

#include <fmt/format.h>

#include <filesystem>

#include "actio/scene/checkpoint.hpp"
#include "actio/scene/own_files.hpp"
#include "actio/scene/run.hpp"

namespace actio::scene {
namespace {

/// How far the run in a folder is, which belongs to the scene.
std::pair<Progression, Taken> progression(Scene const& scene, std::string const& folder, Place const& place) {
  std::string const path = folder + "/checkpoint";
  CheckpointStream stream(read_checkpoint(path, what_determines(scene.file)));
  Progression at;
  Taken taken;
  bool const with_snapshots = scene.snapshots && scene.simulation.snapshots;
  if (stream.bytes().size() < sizeof at + (with_snapshots ? sizeof taken : 0))
    throw FileError(path + ": is damaged: it ends too early");
  stream(at);
  check_rows(at, scene, place);
  if (with_snapshots) stream(taken), check_snapshots(taken, scene, place);
  return {at, taken};
}

}  // namespace

void check_rows(Progression const& at, Scene const& scene, Place const& place) {
  if (at.rows == 0 || (at.rows <= scene.schedule.rows() && scene.schedule.time(at.rows - 1) == at.time))
    return;
  throw SceneError(place, fmt::format("the run has a row at t = {} already, which a run to t = {} has not; "
                                      "its scene can be run anew, into another folder",
                                      at.time, scene.schedule.until()));
}

void check_snapshots(Taken const& taken, Scene const& scene, Place const& place) {
  Schedule const& times = *scene.snapshots;
  if (taken.snapshots == 0 ||
      (taken.snapshots <= times.rows() && times.time(taken.snapshots - 1) == taken.time))
    return;
  throw SceneError(place,
                   fmt::format("the run has a snapshot at t = {} already, which a run to t = {} has not; "
                               "its scene can be run anew, into another folder",
                               taken.time, scene.schedule.until()));
}

bool run_is_finished(Scene const& scene, std::string const& folder) {
  auto const [at, taken] = progression(scene, folder, scene.file.section("run").place("until"));
  bool const with_snapshots = scene.snapshots && scene.simulation.snapshots;
  return at.rows == scene.schedule.rows() &&
         (!with_snapshots || taken.snapshots == scene.snapshots->rows()) &&
         std::filesystem::exists(folder + "/summary.json");
}

Scene extended(Scene const& scene, std::string const& folder, double until) {
  Place const here{fmt::format("--until {}", until)};
  SceneTable const run = scene.file.section("run");
  if (run.has("at")) {
    auto const times = run.numbers("at");
    throw SceneError(here, fmt::format("the rows are at the times that [run] at lists, the last at t = {}, "
                                       "and a longer run has no others; a new scene can list more",
                                       times.back()));
  }
  if (!(until > scene.schedule.until()))
    throw SceneError(here, fmt::format("the run goes to t = {} already; a later time is expected",
                                       scene.schedule.until()));
  std::string const path = folder + "/scene.toml";
  try {
    Scene const longer = Scene::read(SceneFile::read(path, {fmt::format("run.until={}", until)}));
    if (std::filesystem::exists(folder + "/checkpoint")) progression(longer, folder, here);
    // A checkpoint does not say how far a run is to go: it belongs to the scene before this instant and after
    // it.
    write_whole_file(path, longer.file.written());
    return Scene::read(SceneFile::read(path));
  } catch (SceneError const& error) {
    if (error.place.file == here.file) throw;
    throw SceneError(here, error.what());  // for instance that the step does not meet the time
  }
}

}  // namespace actio::scene
