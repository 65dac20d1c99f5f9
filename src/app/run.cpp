#include "actio/scene/run.hpp"

#include <fmt/format.h>

#include <filesystem>

#include "actio/scene/interrupt.hpp"
#include "app/commands.hpp"

namespace actio::app {

using namespace scene;

int run(RunArguments const& arguments) {
  Scene scene = Scene::read(SceneFile::read(arguments.scene, arguments.set));
  std::string const out = arguments.out.empty() ? std::filesystem::path(arguments.scene).replace_extension().string() : arguments.out;
  if (arguments.dry_run) return plan(scene, arguments, out);
  if (std::filesystem::exists(out) && !std::filesystem::is_empty(out) && !arguments.force) throw SceneError({out}, "the folder is not empty; --force replaces the run in it");
  std::filesystem::create_directories(out);
  listen_for_interrupts();
  RunReport const report = run_scene(scene, out, false, {arguments.quiet});
  if (!report.message.empty()) fmt::print(stderr, "{}\n", report.message);
  return static_cast<int>(report.ending);
}

}  // namespace actio::app
