#include "program/run/progression.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "program/base/own_files.hpp"
#include "program/document/input_files.hpp"
#include "program/run/checkpoint.hpp"
#include "program/run/run.hpp"

namespace actio::scene {
namespace {

/// How far the run in a folder is, which belongs to the scene.
std::pair<Progression, Taken> progression(Scene const& scene, std::string const& folder, Place const& place) {
  std::string const path = folder + "/checkpoint";
  CheckpointStream stream(read_checkpoint(path, what_determines(scene.file)));
  Progression at;
  Taken taken;
  InputFiles inputs;
  bool const with_snapshots = scene.snapshots && scene.simulation.snapshots;
  try {
    remember(stream, inputs);
    stream(at);
    if (with_snapshots) stream(taken);
  } catch (Error const& error) {
    throw FileError(path + ": is damaged: " + error.what());
  }
  check_rows(at, scene, place);
  if (with_snapshots) check_snapshots(taken, scene, place);
  return {at, taken};
}

/// The remarks at the head of a scene, which tell how its run came about.
std::string head_of(std::string const& text) {
  std::size_t end = 0;
  while (end < text.size() && text[end] == '#') end = std::min(text.find('\n', end), text.size() - 1) + 1;
  return text.substr(0, end);
}

/// The scene of a run, changed as an option says.
/// @param here  the option, in whose name what is wrong is told
Scene changed(Place const& here, std::string const& folder, std::vector<std::string> const& overrides) {
  try {
    return Scene::read(SceneFile::read(folder + "/scene.toml", overrides));
  } catch (SceneError const& error) {
    throw SceneError(here, error.what());  // for instance that the step does not meet the time
  }
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
  std::string const summary = folder + "/summary.json";
  return at.rows == scene.schedule.rows() &&
         (!with_snapshots || taken.snapshots == scene.snapshots->rows()) &&
         std::filesystem::exists(summary) &&
         SceneFile::text_of(summary).find("\"status\": \"failed\"") == std::string::npos;
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
  Scene const longer = changed(here, folder, {fmt::format("run.until={}", until)});
  if (std::filesystem::exists(folder + "/checkpoint")) progression(longer, folder, here);
  // A checkpoint does not say how far a run is to go: it belongs to the scene before this instant and after
  // it.
  write_whole_file(path, head_of(SceneFile::text_of(path)) + longer.file.written());
  return Scene::read(SceneFile::read(path));
}

Scene with_other_step(Scene const& scene, std::string const& folder, double step) {
  Place const here{fmt::format("--step {}", step)};
  if (scene.simulation.exact)
    throw SceneError(here, "the method of this run goes to any time at once, and has no steps");
  if (step == scene.simulation.step) throw SceneError(here, "the steps of this run have that length already");
  std::vector<std::string> overrides{fmt::format("method.step={}", step), "output.error_estimate=false"};
  if (scene.accuracy) overrides.insert(overrides.end(), {"!run.accuracy", "!run.chosen_for"});
  Scene out = changed(here, folder, overrides);
  refuse_without_step(out);
  return out;
}

void finish_change_of_step(std::string const& folder) {
  std::string const path = folder + "/scene.toml", part = path + ".part", checkpoint = folder + "/checkpoint";
  if (!std::filesystem::exists(part) || !std::filesystem::exists(checkpoint)) return;
  try {
    read_checkpoint(checkpoint, what_determines(Scene::read(SceneFile::read(part)).file));
  } catch (Error const&) {
    return;  // something else left it
  }
  std::filesystem::rename(part, path);
}

std::string in_words(StepChange const& change) {
  return fmt::format("from t = {} on the steps have the length {}, before {}", change.time, change.step,
                     change.before);
}

}  // namespace actio::scene
