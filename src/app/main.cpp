// The command actio: scenes, run and looked at. Here are its arguments; what it does is in the files beside this one.
#include <CLI/CLI.hpp>

#include "actio/scene/progress.hpp"
#include "actio/scene/scene_error.hpp"
#include "app/commands.hpp"

using namespace actio;

int main(int argc, char** argv) {
  CLI::App command{"Mechanics on Lie groups, step by step, from one action principle.", "actio"};
  command.require_subcommand(1);
  int status = 0;

  app::RunArguments run;
  auto* const run_command = command.add_subcommand("run", "run a scene");
  run_command->add_option("SCENE", run.scene, "a scene, in TOML")->required();
  run_command->add_option("--out", run.out, "the folder for what the run leaves; otherwise the scene's name beside it")->type_name("DIR");
  run_command->add_option("--set", run.set, "override a key of the scene")->type_name("KEY=VALUE")->allow_extra_args(false);
  run_command->add_flag("--quiet", run.quiet, "no progress");
  run_command->add_flag("--dry-run", run.dry_run, "check the scene and print the plan");
  run_command->add_flag("--plots", run.plots, "draw pictures and a page to play the motion");
  run_command->add_flag("--force", run.force, "replace the run that is in the folder");
  run_command->callback([&] { status = app::run(run); });

  app::ResumeArguments resume;
  auto* const resume_command = command.add_subcommand("resume", "go on with a run from its last checkpoint");
  resume_command->add_option("DIR", resume.folder, "the folder of the run")->required();
  resume_command->add_flag("--quiet", resume.quiet, "no progress");
  resume_command->callback([&] { status = app::resume(resume); });

  app::SweepArguments sweep;
  auto* const sweep_command = command.add_subcommand("sweep", "run a scene for each of many values, into one table");
  sweep_command->add_option("SCENE", sweep.scene, "a scene, in TOML")->required();
  sweep_command->add_option("--over", sweep.over, "a key and its values")->type_name("KEY=a,b,c")->required()->allow_extra_args(false);
  sweep_command->add_option("--out", sweep.out, "the folder for the runs and their table")->type_name("DIR");
  sweep_command->add_option("--set", sweep.set, "override a key in all of them")->type_name("KEY=VALUE")->allow_extra_args(false);
  sweep_command->add_option("--jobs", sweep.jobs, "runs at the same time; otherwise one for each core")->check(CLI::PositiveNumber);
  sweep_command->add_flag("--quiet", sweep.quiet, "no progress");
  sweep_command->add_flag("--force", sweep.force, "replace the runs that are in the folder");
  sweep_command->callback([&] { status = app::sweep(sweep); });

  std::string what, name;
  auto* const list_command = command.add_subcommand("list", "list what there is");
  list_command->add_option("WHAT", what, "systems, groups, methods, quantities, bodies or materials")->required();
  list_command->callback([&] { status = app::list(what); });
  auto* const show_command = command.add_subcommand("show", "tell what something is: meaning, units, source, statement of the thesis");
  show_command->add_option("NAME", name, "a body, material, system, method or quantity")->required();
  show_command->callback([&] { status = app::show(name); });

  std::vector<std::string> ids;
  auto* const check_command = command.add_subcommand("check", "run the theorem checks");
  check_command->add_option("ID", ids, "statements, for example thm_3_2_1; none: all");
  check_command->callback([&] { status = app::check(ids); });

  try {
    command.parse(argc, argv);
    return status;
  } catch (CLI::ParseError const& error) {
    return command.exit(error) == 0 ? 0 : 2;
  } catch (scene::SceneError const& error) {
    scene::say(stderr, std::string(error.what()) + "\n");
    return 2;
  } catch (scene::NumericsError const& error) {
    scene::say(stderr, std::string(error.what()) + "\n");
    return 3;
  } catch (scene::FileError const& error) {
    scene::say(stderr, std::string(error.what()) + "\n");
    return 4;
  }
}
