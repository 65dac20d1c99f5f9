// The command actio: scenes, run and looked at. Here are its arguments; what it does is in the files beside
// this one.
#include <fmt/format.h>

#include <cstdio>
#include <cstdlib>
#include <functional>
#include <new>
#include <system_error>

#include "app/commands.hpp"
#include "app/sweep_arguments.hpp"
#include "app/usage.hpp"
#include "program/base/error.hpp"
#include "program/base/progress.hpp"

using namespace actio;

namespace {

/// A part of the command, and what is to be done where it was chosen.
using Action = std::function<int()>;

constexpr char const* exit_statuses =
    "Exit status: 0 done, 1 a theorem check failed, 2 the scene or the command "
    "line is wrong, 3 the numerics\n"
    "failed (for instance a step too long for the method), 4 the disk or a file failed, 130 interrupted.";

CLI::App* add_part(CLI::App& command, std::string const& name, std::string const& meaning,
                   std::string const& footer, Action& action, Action part) {
  CLI::App* const added = command.add_subcommand(name, meaning);
  added->footer(footer);
  added->set_help_flag("-h,--help", "this text");
  added->callback([&action, part] { action = part; });
  return added;
}

std::string not_empty(std::string& text) { return text.empty() ? "a name is expected, found ''" : ""; }

void add_run(CLI::App& command, app::RunArguments& run, Action& action) {
  auto* const part = add_part(command, "run", "run a scene",
                              "Example: actio run apophis.toml --out results --set method.step=0.5\n\n"
                              "The folder receives series.csv, summary.json and scene.toml, in "
                              "which every default is written out.",
                              action, [&run] { return app::run(run); });
  part->add_option("SCENE", run.scene,
                   "a scene, in TOML; or the name of one that comes with actio, as apophis (actio list "
                   "scenes); - reads it from standard input")
      ->required()
      ->check(CLI::Validator(not_empty, ""));
  part->add_option("--out", run.out,
                   "the folder for what the run leaves; otherwise the scene's name beside it")
      ->type_name("DIR")
      ->check(CLI::Validator(not_empty, ""));
  part->add_option(
          "--set", run.set,
          "override a key of the scene; the value in TOML, a bare word being a text; as often as you like")
      ->type_name("KEY=VALUE")
      ->allow_extra_args(false);
  part->add_option("--unset", run.unset, "take a key out of the scene")
      ->type_name("KEY")
      ->allow_extra_args(false);
  part->add_flag("--quiet", run.quiet, "no progress")->disable_flag_override();
  part->add_flag("--dry-run", run.dry_run, "check the scene and print the plan, and run nothing")
      ->disable_flag_override();
  part->add_option("--ranks", run.ranks,
                   "with --dry-run: how much memory each of so many ranks of actio-mpi takes")
      ->type_name("P")
      ->check(CLI::Range(1, 1 << 20));
  part->add_flag("--plots", run.plots, "draw pictures and a page to play the motion")
      ->disable_flag_override();
  part->add_flag("--force", run.force,
                 "replace the run that is in the folder: the files that actio wrote, and nothing else")
      ->disable_flag_override();
}

void add_resume(CLI::App& command, app::ResumeArguments& resume, Action& action) {
  auto* const part = add_part(command, "resume", "go on with a run from its last checkpoint, or with a sweep",
                              "Example: actio resume apophis\n\n"
                              "The joined run equals an unbroken one bit for bit. Of a sweep, "
                              "members that are done are kept.",
                              action, [&resume] { return app::resume(resume); });
  part->add_option("DIR", resume.folder, "the folder of the run, or of the sweep")
      ->required()
      ->check(CLI::Validator(not_empty, ""));
  part->add_option("--until", resume.until,
                   "go on to a later time than the scene says, and write it into scene.toml")
      ->type_name("T")
      ->check(CLI::Validator(not_empty, ""));
  part->add_option("--step", resume.step,
                   "go on with steps of another length, and write it into scene.toml; "
                   "rows are at multiples of it, too")
      ->type_name("H")
      ->check(CLI::Validator(not_empty, ""));
  app::add_jobs_option(*part, resume.jobs, "of a sweep: runs at the same time; otherwise one for each core");
  part->add_flag("--plots", resume.plots, "draw pictures and a page to play the motion")
      ->disable_flag_override();
  part->add_flag("--quiet", resume.quiet, "no progress")->disable_flag_override();
}

void add_plot(CLI::App& command, app::PlotArguments& plot, Action& action) {
  auto* const part =
      add_part(command, "plot", "draw the pictures of a run: finished, interrupted, or going on",
               "Example: actio plot apophis\n\n"
               "The folder receives plots/*.svg and plots/index.html, of the rows that are there.",
               action, [&plot] { return app::plot(plot); });
  part->add_option("DIR", plot.folder, "the folder of the run")
      ->required()
      ->check(CLI::Validator(not_empty, ""));
  part->add_flag("--quiet", plot.quiet, "no progress")->disable_flag_override();
}

void add_export(CLI::App& command, app::ExportArguments& made, Action& action) {
  auto* const part = add_part(
      command, "export", "make files of a run for other programs: finished, interrupted, or going on",
      "Example: actio export apophis --formats hdf5\n\n"
      "They are made of series.csv and snapshots/*.csv, whole, and take the place of those that are there.",
      action, [&made] { return app::export_run(made); });
  part->add_option("DIR", made.folder, "the folder of the run")
      ->required()
      ->check(CLI::Validator(not_empty, ""));
  part->add_option("--formats", made.formats,
                   "hdf5, netcdf, vtu, as the system has them (actio show output.formats), with commas "
                   "between; otherwise those that the scene asks for")
      ->type_name("FORMAT,...")
      ->check(CLI::Validator(not_empty, ""));
  part->add_flag("--quiet", made.quiet, "no progress")->disable_flag_override();
}

void add_sweep(CLI::App& command, app::SweepArguments& sweep, Action& action) {
  auto* const part = add_part(command, "sweep", "run a scene for each of many values, into one table",
                              "Example: actio sweep apophis.toml --over method.step=0.1,0.2,0.4", action,
                              [&sweep] { return app::sweep(sweep); });
  app::add_sweep_options(*part, sweep);
}

void add_new(CLI::App& command, app::NewArguments& made, Action& action) {
  auto* const part =
      add_part(command, "new", "print a scene to begin with",
               "Example: actio new rigid_body --body t_handle --out mine.toml\n\n"
               "A system has a scene with every key and what it means; a scene that comes with actio "
               "(actio list scenes) is printed as it is; a body is let go. Each runs as it is.",
               action, [&made] { return app::make_new(made); });
  part->add_option("KIND", made.name, "a system, a scene that comes with actio, or a body of the library")
      ->required()
      ->check(CLI::Validator(not_empty, ""));
  part->add_option("--body", made.body, "a body of the library, for rigid_body")
      ->type_name("BODY")
      ->check(CLI::Validator(not_empty, ""));
  part->add_option("--out", made.out, "a new file for the scene; otherwise it is printed")
      ->type_name("FILE")
      ->check(CLI::Validator(not_empty, ""));
}

/// What the parts that look things up are asked.
struct Questions {
  std::string list, name;
  std::vector<std::string> ids;
  bool list_statements = false, json = false;
};

void add_questions(CLI::App& command, Questions& asked, Action& action) {
  auto* part =
      add_part(command, "list",
               "list what there is: systems, groups, methods, quantities, bodies, materials, keys, scenes",
               "Example: actio list bodies\n\nA line for each; its first word is the name.", action,
               [&asked] { return app::list(asked.list, asked.json); });
  part->add_option("WHAT", asked.list,
                   "systems, groups, methods, quantities, bodies, materials, keys (of a scene) "
                   "or scenes (that come with actio)")
      ->required()
      ->check(CLI::Validator(not_empty, ""));
  part->add_flag("--json", asked.json, "systems or keys, with all that is known of them, for other programs")
      ->disable_flag_override();
  part = add_part(command, "show", "tell what something is: meaning, units, source, statement of the thesis",
                  "Example: actio show apophis\n\n"
                  "A key of a scene is named with its section, as run.every; a statement as thm_3_2_1, "
                  "\"(3.10)\" or \"Theorem 3.2.1\".",
                  action, [&asked] { return app::show(asked.name); });
  part->add_option("NAME", asked.name,
                   "a system, group, method, quantity, body, material, key of a scene, scene or statement")
      ->required()
      ->check(CLI::Validator(not_empty, ""));
  part = add_part(
      command, "check", "run the theorem checks",
      "Example: actio check thm_3_2_1\n\n"
      "Exit status: 0 all pass, 1 one fails, 2 an id is unknown or has no "
      "check, 4 the checks are not built.",
      action, [&asked] { return asked.list_statements ? app::list_statements() : app::check(asked.ids); });
  part->add_option(
      "ID", asked.ids,
      "statements of the thesis, for example thm_3_2_1, \"(3.10)\" or \"Theorem 3.2.1\"; none: all");
  part->add_flag("--list", asked.list_statements, "list the statements that have a check, and run none")
      ->disable_flag_override();
}

/// Reads the arguments, does what they ask for, and makes a line and a status of what goes wrong.
int answer(CLI::App& command, Action const& action, int argc, char** argv) {
  try {
    if (argc == 1) {
      fmt::print(stderr, "{}", command.help());
      return 2;
    }
    command.parse(argc, argv);
    int const status = action();
    if (std::fflush(stdout) != 0) throw scene::FileError("standard output: cannot be written");
    return status;
  } catch (CLI::Success const& help) {
    return command.exit(help);
  } catch (CLI::ParseError const& error) {
    fmt::print(stderr, "{}\n", app::usage_error(command, error));
    return 2;
  } catch (scene::SceneError const& error) {
    scene::say(stderr, std::string(error.what()) + "\n");
    return 2;
  } catch (scene::NumericsError const& error) {
    scene::say(stderr, std::string(error.what()) + "\n");
    return 3;
  } catch (scene::FileError const& error) {
    scene::say(stderr, std::string(error.what()) + "\n");
    return 4;
  } catch (std::system_error const& error) {
    scene::say(stderr, std::string("standard output: ") + error.what() + "\n");
    return 4;
  } catch (std::bad_alloc const&) {
    scene::say(stderr, "The memory does not suffice.\n");
    return 4;
  }
}

}  // namespace

int actio::app::command(int argc, char** argv) {
  // The folder of a run is locked as a whole, and not every file system has locks for the libraries that make
  // its files.
  ::setenv("HDF5_USE_FILE_LOCKING", "FALSE", 1);
  CLI::App command{
      "Mechanics on Lie groups, step by step, from one action principle: scenes, run and looked at", "actio"};
  command.require_subcommand(1);
  command.formatter(std::make_shared<app::Help>());
  command.set_help_flag("-h,--help", "this text");
  command.set_version_flag("--version", "actio " ACTIO_VERSION, "which version this is");
  command.footer(std::string("actio COMMAND --help says more of each.\n\n"
                             "Example: actio run apophis            a scene that comes "
                             "with actio (actio list scenes)\n"
                             "         actio new rigid_body --out mine.toml            a scene "
                             "of your own, to edit and run\n\n") +
                 exit_statuses);

  Action action;
  app::RunArguments run;
  app::ResumeArguments resume;
  app::PlotArguments plot;
  app::ExportArguments exported;
  app::SweepArguments sweep;
  app::NewArguments made;
  Questions asked;
  add_run(command, run, action);
  add_resume(command, resume, action);
  add_plot(command, plot, action);
  add_export(command, exported, action);
  add_sweep(command, sweep, action);
  add_new(command, made, action);
  add_questions(command, asked, action);
  return answer(command, action, argc, argv);
}
