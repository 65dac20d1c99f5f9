#include <filesystem>

#include "app/commands.hpp"
#include "app/run_to_end.hpp"
#include "app/scene_argument.hpp"

namespace actio::app {

using namespace scene;

namespace {

/// The run may not take the place of the scene that it is read from, unless that is what it would write
/// there.
void keep_the_scene(RunArguments const& arguments, std::string const& out, Scene const& scene) {
  std::error_code none;
  if (arguments.scene != "-" && std::filesystem::equivalent(arguments.scene, out + "/scene.toml", none) &&
      SceneFile::read(arguments.scene).written() != scene.file.written())
    throw SceneError(
        {out}, "the copy of the scene would be written over the scene itself; --out names another folder");
}

}  // namespace

int run(RunArguments const& arguments) {
  open_standard_streams();
  Scene scene =
      Scene::read(scene_of(arguments.scene, overrides(arguments.set, arguments.unset, arguments.plots)));
  refuse_on_ranks(scene);
  std::string const out =
      arguments.out.empty() ? folder_beside(arguments.scene, arguments.dry_run) : arguments.out;
  if (arguments.dry_run) {
    if (!scene.simulation.failure.empty()) throw NumericsError(scene.simulation.failure);
    return plan(scene, arguments, out);
  }
  keep_the_scene(arguments, out, scene);
  refuse_without_step(scene);
  listen_for_interrupts();
  RunFolder const folder = RunFolder::create(out, arguments.force, files_of_run(scene));
  return run_to_end(scene, folder, false, arguments.quiet);
}

}  // namespace actio::app
