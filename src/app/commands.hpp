// What the command actio can be told to do. Each function does it, says what went wrong on standard error by throwing, and returns the exit status.
#pragma once

#include <string>
#include <vector>

namespace actio::scene {
struct Scene;
}

namespace actio::app {

struct RunArguments {
  std::string scene, out;            ///< out: the scene's name beside it where empty
  std::vector<std::string> set;      ///< KEY=VALUE
  bool quiet = false, dry_run = false, plots = false, force = false;
};
int run(RunArguments const& arguments);
/// What `run` would do with a scene that was read, and what it would leave in the folder `out`.
int plan(scene::Scene const& scene, RunArguments const& arguments, std::string const& out);

struct ResumeArguments {
  std::string folder;
  bool quiet = false;
};
int resume(ResumeArguments const& arguments);

struct SweepArguments {
  std::string scene, out;
  std::vector<std::string> over;     ///< KEY=a,b,c
  std::vector<std::string> set;
  int jobs = 0;                      ///< 0: as many as the machine has cores
  bool quiet = false, force = false;
};
int sweep(SweepArguments const& arguments);

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
