// actio export DIR: files of a run for other programs, made of its plain ones.
#include <fmt/format.h>

#include <algorithm>
#include <sstream>

#include "actio/numbers/nearest_name.hpp"
#include "app/commands.hpp"
#include "program/base/interrupt.hpp"
#include "program/base/own_files.hpp"
#include "program/base/progress.hpp"
#include "program/run/exports.hpp"
#include "program/run/run_folder.hpp"

namespace actio::app {

using namespace scene;

namespace {

/// Those that are asked for, each of which the run can be had in.
std::vector<std::string> formats_of(ExportArguments const& arguments, Scene const& scene) {
  auto const known = formats_of_exports(scene);
  std::string names;
  for (auto const& name : known) names += (names.empty() ? "" : ", ") + name;
  std::vector<std::string> out;
  if (arguments.formats.empty())
    std::copy_if(scene.formats.begin(), scene.formats.end(), std::back_inserter(out),
                 [](auto const& format) { return format != "csv"; });
  std::istringstream asked(arguments.formats);
  for (std::string name; std::getline(asked, name, ',');) {
    if (std::find(known.begin(), known.end(), name) == known.end())
      throw SceneError({"--formats " + arguments.formats},
                       fmt::format("unknown format '{}' of {}, whose runs can be had as {}{}", name,
                                   scene.system->name, names, did_you_mean(name, known)));
    if (std::find(out.begin(), out.end(), name) == out.end()) out.push_back(name);
  }
  if (out.empty())
    throw SceneError({arguments.folder},
                     "the scene asks for no other format than csv; --formats names one: " + names);
  return out;
}

}  // namespace

int export_run(ExportArguments const& arguments) {
  open_standard_streams();
  std::string const folder = RunFolder::look(arguments.folder);
  Scene const scene = Scene::read(SceneFile::read(folder + "/scene.toml"));
  long const most = scene.snapshots ? scene.snapshots->rows() : 0;
  for (auto const& format : formats_of(arguments, scene)) {
    auto files = files_of_export(scene, format, most);
    if (files.empty())
      throw SceneError(
          {"--formats " + format},
          format + " holds snapshots, and the scene of this run asks for none (output.snapshots)");
    for (std::size_t k = files.size(); k-- > 0;) files.push_back(files[k] + ".part");
    OwnFiles(folder).claim(files);
    Progress progress(arguments.quiet, "percent");
    progress.start(0, 0);
    make_exports(scene, folder, {format}, {true, true, [&](double done) {
                                             progress.show(Progress::Clock::now(), done,
                                                           static_cast<long>(100 * done), std::nullopt);
                                           }});
    for (auto const& file : files_of_export(scene, format, 0))
      if (!arguments.quiet) say(stdout, fmt::format("{}/{} is made\n", folder, file));
  }
  return 0;
}

}  // namespace actio::app
