#include <fmt/format.h>

#include <filesystem>

#include "actio/scene/progress.hpp"
#include "app/commands.hpp"
#include "app/run_to_end.hpp"

namespace actio::app {

using namespace scene;

int resume(ResumeArguments const& arguments) {
  open_standard_streams();
  if (is_sweep(arguments.folder)) return resume_sweep(arguments);
  RunFolder const folder = RunFolder::open(arguments.folder);
  Scene scene = Scene::read(SceneFile::read(folder / "scene.toml"));
  bool const begun = std::filesystem::exists(folder / "checkpoint");
  if (begun && run_is_finished(scene, folder.path())) {
    if (!arguments.quiet) say(stdout, fmt::format("{}: the run is finished, with {} rows to t = {}; nothing is left to do\n", folder.path(), scene.schedule.rows(), scene.schedule.until()));
    return 0;
  }
  if (!begun) say(stderr, folder.path() + ": there is no checkpoint yet; the run starts anew from its scene.toml\n");
  listen_for_interrupts();
  return run_to_end(scene, folder, begun, arguments.quiet);
}

}  // namespace actio::app
