// actio plot DIR: the pictures of a run that is there, finished or not.
#include <fmt/format.h>

#include <filesystem>

#include "app/commands.hpp"
#include "app/draw.hpp"
#include "app/text.hpp"
#include "program/base/progress.hpp"
#include "program/run/run.hpp"
#include "program/run/run_folder.hpp"

namespace actio::app {

using namespace scene;

namespace {

/// `; the run goes on, and these are of its rows so far`
std::string how_far(Scene const& scene, std::string const& folder) {
  if (RunFolder::in_use(folder)) return "; of the rows so far, for the run goes on";
  try {
    if (run_is_finished(scene, folder)) return "";
  } catch (Error const&) {
    return "";  // whatever is wrong with its checkpoint, these are pictures of what is in its table
  }
  return fmt::format("; of the rows so far, for the run is not finished: actio resume {} goes on with it",
                     in_shell(folder));
}

}  // namespace

int plot(PlotArguments const& arguments) {
  open_standard_streams();
  std::string const folder = RunFolder::look(arguments.folder);
  Scene const scene = Scene::read(SceneFile::read(folder + "/scene.toml"));
  draw(scene, folder, arguments.quiet);
  long pictures = 0;
  for (auto const& entry : std::filesystem::directory_iterator(folder + "/plots"))
    pictures += entry.path().extension() == ".svg";
  if (!arguments.quiet)
    say(stdout, fmt::format("{}/plots: {} picture{} and index.html{}\n", folder, pictures,
                            pictures == 1 ? "" : "s", how_far(scene, folder)));
  return 0;
}

}  // namespace actio::app
