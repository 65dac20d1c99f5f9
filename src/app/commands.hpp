// What the command actio can be told to do. Each function does it, says what went wrong on standard error by
// throwing, and returns the exit status.
#pragma once

#include <string>
#include <vector>

namespace actio::scene {
struct Scene;
}

namespace actio::app {

/// The command: reads its arguments and does what they ask for.
/// @return  its exit status
int command(int argc, char** argv);

struct RunArguments {
  std::string scene, out;          ///< out: the scene's name beside it where empty
  std::vector<std::string> set;    ///< KEY=VALUE
  std::vector<std::string> unset;  ///< KEY
  bool quiet = false, dry_run = false, plots = false, force = false;
  int ranks = 1;  ///< whose memory the plan tells
};
int run(RunArguments const& arguments);
/// What `run` would do with a scene that was read, and what it would leave in the folder `out`.
int plan(scene::Scene& scene, RunArguments const& arguments, std::string const& out);

struct ResumeArguments {
  std::string folder;
  std::string until;  ///< a later end than the scene has; empty: none
  std::string step;   ///< another step; empty: that of the scene
  int jobs = 0;       ///< of a sweep; 0: as many as the machine has cores
  bool quiet = false, plots = false;
};
int resume(ResumeArguments const& arguments);

struct PlotArguments {
  std::string folder;
  bool quiet = false;
};
/// Draws the pictures of a run that is there.
int plot(PlotArguments const& arguments);

struct ExportArguments {
  std::string folder, formats;  ///< formats: with commas between; empty: those of the scene
  bool quiet = false;
};
/// Makes files of other formats out of the plain ones of a run that is there.
int export_run(ExportArguments const& arguments);

struct SweepArguments {
  std::string scene, out;
  std::string resume;             ///< the folder of a sweep that goes on; the scene is not given then
  std::vector<std::string> over;  ///< KEY=a,b,c
  std::vector<std::string> set, unset;
  int jobs = 0;  ///< 0: as many as the machine has cores
  bool quiet = false, force = false, dry_run = false, plots = false;
};
int sweep(SweepArguments const& arguments);
/// Goes on with the sweep in a folder.
int resume_sweep(ResumeArguments const& arguments);
/// Whether there is one.
bool is_sweep(std::string const& folder);

/// What KEY=VALUE and KEY of the command line say, as overrides of a scene: what is taken out first.
std::vector<std::string> overrides(std::vector<std::string> const& set, std::vector<std::string> const& unset,
                                   bool plots);

struct NewArguments {
  std::string name,  ///< of a system, of a scene that the program carries, or of a body
      body, out;     ///< body: of the library, or empty; out: standard output where empty
};
int make_new(NewArguments const& arguments);

/// @param what  systems, groups, methods, quantities, bodies, materials, keys, scenes
/// @param json  for other programs: systems or keys, with all that is known of them
int list(std::string const& what, bool json = false);
/// @param name  of a body, a material, a system, a method, a quantity, a group, a key, a scene or a statement
int show(std::string const& name);
/// @param ids  of statements; none: all
/// @return 1 where a check fails
int check(std::vector<std::string> const& ids);
/// The statements that have a check.
int list_statements();

}  // namespace actio::app
