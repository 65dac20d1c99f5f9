#include "app/sweep_arguments.hpp"

#include <CLI/CLI.hpp>

#include <filesystem>

#include "program/base/progress.hpp"
#include "program/sweep/sweep.hpp"

namespace actio::app {
namespace {

/// At least one run at a time.
std::string whole_and_positive(std::string& text) {
  bool const whole = !text.empty() && text.size() < 10 &&
                     text.find_first_not_of("0123456789") == std::string::npos && std::stol(text) > 0;
  return whole ? "" : "a whole number from 1 on is expected, found '" + text + "'";
}

}  // namespace

void add_jobs_option(CLI::App& command, int& jobs, char const* meaning) {
  command.add_option("--jobs", jobs, meaning)->type_name("N")->check(CLI::Validator(whole_and_positive, ""));
}

std::vector<std::string> overrides(std::vector<std::string> const& set, std::vector<std::string> const& unset,
                                   bool plots) {
  std::vector<std::string> out;
  for (auto const& key : unset) out.push_back("!" + key);
  out.insert(out.end(), set.begin(), set.end());
  if (plots) out.push_back("output.plots=true");
  return out;
}

void add_sweep_options(CLI::App& command, SweepArguments& arguments) {
  command.add_option("SCENE", arguments.scene, "a scene, in TOML")
      ->required()
      ->check(CLI::Validator(
          [](std::string& text) {
            return text.empty() ? std::string("a name is expected, found ''") : std::string();
          },
          ""));
  command
      .add_option("--over", arguments.over,
                  "a key and its values: a,b,c, or START:STOP:STEP, linspace(A, B, N), geomspace(A, B, N), "
                  "or @FILE with one a line; KEY[0] is one item of a list; several --over: all "
                  "combinations, the last the fastest")
      ->type_name("KEY=VALUES")
      ->required()
      ->allow_extra_args(false);
  command
      .add_option("--out", arguments.out,
                  "the folder for the runs and their table; otherwise the scene's name beside it")
      ->type_name("DIR");
  command.add_option("--set", arguments.set, "override a key in all of them")
      ->type_name("KEY=VALUE")
      ->allow_extra_args(false);
  command.add_option("--unset", arguments.unset, "take a key out of the scene in all of them")
      ->type_name("KEY")
      ->allow_extra_args(false);
  add_jobs_option(command, arguments.jobs, "runs at the same time; otherwise one for each core");
  command.add_flag("--quiet", arguments.quiet, "no progress, no messages of members, no closing line")
      ->disable_flag_override();
  command
      .add_flag("--dry-run", arguments.dry_run, "read all scenes, tell what would be run, and run nothing")
      ->disable_flag_override();
  command.add_flag("--plots", arguments.plots, "draw pictures of each member")->disable_flag_override();
  command.add_flag("--force", arguments.force, "replace the sweep that is in the folder, and nothing else")
      ->disable_flag_override();
}

std::optional<int> read_sweep_arguments(int argc, char** argv, char const* name, char const* meaning,
                                        SweepArguments& arguments) {
  CLI::App command{meaning, name};
  command.set_help_flag("-h,--help", "this text");
  add_sweep_options(command, arguments);
  command
      .add_option("--resume", arguments.resume,
                  "go on with the sweep in this folder, without SCENE and --over")
      ->type_name("DIR");
  command.get_option("SCENE")->required(false), command.get_option("--over")->required(false);
  try {
    command.parse(argc, argv);
    if (arguments.resume.empty() == (arguments.scene.empty() || arguments.over.empty()))
      throw CLI::ParseError("either SCENE and --over, or --resume DIR are expected", 2);
    return {};
  } catch (CLI::Success const& help) {
    return command.exit(help);
  } catch (CLI::ParseError const& error) {
    scene::say(stderr, name + std::string(": ") + error.what() + " (" + name + " --help)\n");
    return 2;
  }
}

scene::SweepPlan sweep_plan(SweepArguments const& arguments) {
  if (!arguments.resume.empty()) return scene::SweepPlan::resumed(arguments.resume);
  std::string const folder = arguments.out.empty()
                                 ? std::filesystem::path(arguments.scene).replace_extension().string()
                                 : arguments.out;
  scene::SweepPlan plan(arguments.scene, arguments.over,
                        overrides(arguments.set, arguments.unset, arguments.plots), folder);
  plan.read_scene();
  return plan;
}

}  // namespace actio::app
