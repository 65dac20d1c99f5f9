#include <fmt/format.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>

#include "app/commands.hpp"
#include "app/draw.hpp"
#include "app/run_to_end.hpp"
#include "program/base/progress.hpp"
#include "program/run/checkpoint.hpp"
#include "program/run/exports.hpp"
#include "program/run/run_files.hpp"

namespace actio::app {

using namespace scene;

namespace {

/// @param option  "--until", whose value is the text
double time_of(std::string const& option, std::string const& text) {
  char* end = nullptr;
  double const time = std::strtod(text.c_str(), &end);
  if (end == text.c_str() || *end || !std::isfinite(time))
    throw SceneError({option + " " + text}, "a time is expected, for example " + option + " 500");
  return time;
}

/// Of a run that is finished there may be pictures to draw.
int after_the_end(Scene const& scene, std::string const& folder, bool quiet) {
  if (scene.snapshots && scene.simulation.snapshots)
    if (auto const gone = missing_snapshots(scene, folder, scene.snapshots->rows()); gone.count > 0)
      say(stderr, gone.told + "\n");
  if (!std::filesystem::exists(folder + "/series.csv"))
    throw FileError(
        folder +
        "/series.csv: is not there any more, and the run is finished; a run of its scene.toml into "
        "another folder writes it again");
  for (auto const& format : scene.formats)
    for (auto const& name : files_of_export(scene, format, 0))
      if (!std::filesystem::exists(folder + "/" + name)) {
        make_exports(scene, folder, {format});
        say(stderr, folder + "/" + name + " was missing, and is made again\n");
      }
  bool const missing = scene.plots && !drawn(folder);
  if (missing) draw(scene, folder, quiet);
  if (!quiet)
    say(stdout, fmt::format("{}: the run is finished, with {} rows to t = {}; {}\n", folder,
                            scene.schedule.rows(), scene.schedule.until(),
                            missing ? "its pictures were missing and are drawn" : "nothing is left to do"));
  return 0;
}

}  // namespace

int resume(ResumeArguments const& arguments) {
  open_standard_streams();
  if (is_sweep(arguments.folder)) {
    char const* const of_runs = !arguments.until.empty()  ? "--until"
                                : !arguments.step.empty() ? "--step"
                                : arguments.plots         ? "--plots"
                                                          : nullptr;
    if (of_runs)
      throw SceneError(
          {arguments.folder},
          fmt::format(
              "{} is for a run, and this is the folder of a sweep; one of its members can be resumed with it",
              of_runs));
    return resume_sweep(arguments);
  }
  RunFolder const folder = RunFolder::open(arguments.folder);
  bool const begun = std::filesystem::exists(folder / "checkpoint");
  if (begun) finish_change_of_step(folder.path()), refuse_changed_inputs(folder.path());
  Scene scene = Scene::read(SceneFile::read(folder / "scene.toml"));
  if (!arguments.until.empty()) scene = extended(scene, folder.path(), time_of("--until", arguments.until));
  refuse_on_ranks(scene);
  scene.plots = scene.plots || arguments.plots;
  if (begun && run_is_finished(scene, folder.path()))
    return after_the_end(scene, folder.path(), arguments.quiet);
  if (!arguments.step.empty()) {
    double const step = time_of("--step", arguments.step);
    if (!begun)
      throw SceneError(
          {"--step " + arguments.step},
          "there is no checkpoint to go on from; actio run takes --set method.step=" + arguments.step);
    Scene other = with_other_step(scene, folder.path(), step);
    other.plots = scene.plots;
    listen_for_interrupts();
    return run_to_end(other, folder, begun, arguments.quiet, &scene);
  }
  if (!begun)
    say(stderr, folder.path() + ": there is no checkpoint yet; the run starts anew from its scene.toml\n");
  listen_for_interrupts();
  return run_to_end(scene, folder, begun, arguments.quiet);
}

}  // namespace actio::app
