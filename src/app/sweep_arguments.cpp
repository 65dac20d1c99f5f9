#include "app/sweep_arguments.hpp"

#include <CLI/CLI.hpp>

#include <filesystem>

#include "actio/scene/progress.hpp"
#include "actio/scene/sweep.hpp"

namespace actio::app {
namespace {

/// At least one run at a time.
std::string whole_and_positive(std::string& text) {
  bool const whole = !text.empty() && text.size() < 10 && text.find_first_not_of("0123456789") == std::string::npos && std::stol(text) > 0;
  return whole ? "" : "a whole number from 1 on is expected, found '" + text + "'";
}

}  // namespace

void add_sweep_options(CLI::App& command, SweepArguments& arguments) {
  command.add_option("SCENE", arguments.scene, "a scene, in TOML")->required()->check(CLI::Validator([](std::string& text) { return text.empty() ? std::string("a name is expected, found ''") : std::string(); }, ""));
  command.add_option("--over", arguments.over, "a key and its values; several: all combinations, the last the fastest")->type_name("KEY=a,b,c")->required()->allow_extra_args(false);
  command.add_option("--out", arguments.out, "the folder for the runs and their table; otherwise the scene's name beside it")->type_name("DIR");
  command.add_option("--set", arguments.set, "override a key in all of them")->type_name("KEY=VALUE")->allow_extra_args(false);
  command.add_option("--jobs", arguments.jobs, "runs at the same time; otherwise one for each core")->type_name("N")->check(CLI::Validator(whole_and_positive, ""));
  command.add_flag("--quiet", arguments.quiet, "no progress")->disable_flag_override();
  command.add_flag("--force", arguments.force, "replace the runs that are in the folder")->disable_flag_override();
}

std::optional<int> read_sweep_arguments(int argc, char** argv, char const* name, char const* meaning, SweepArguments& arguments) {
  CLI::App command{meaning, name};
  command.set_help_flag("-h,--help", "this text");
  add_sweep_options(command, arguments);
  try {
    command.parse(argc, argv);
    return {};
  } catch (CLI::Success const& help) {
    return command.exit(help);
  } catch (CLI::ParseError const& error) {
    scene::say(stderr, name + std::string(": ") + error.what() + " (" + name + " --help)\n");
    return 2;
  }
}

scene::SweepPlan sweep_plan(SweepArguments const& arguments) {
  std::string const folder = arguments.out.empty() ? std::filesystem::path(arguments.scene).replace_extension().string() : arguments.out;
  return {arguments.scene, arguments.over, arguments.set, folder};
}

}  // namespace actio::app
