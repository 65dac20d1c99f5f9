// The arguments of a sweep, the same for `actio sweep` and for `actio-mpi`, and what both make of them.
#pragma once

#include <optional>

#include "app/commands.hpp"

namespace CLI {
class App;
}
namespace actio::scene {
class SweepPlan;
}

namespace actio::app {

/// Declares `--jobs N`.
void add_jobs_option(CLI::App& command, int& jobs, char const* meaning);
/// Declares them.
void add_sweep_options(CLI::App& command, SweepArguments& arguments);
/// Reads them all, for a command that does nothing else.
/// @return the exit status where the command is to end here: help was asked for (0), or an argument is wrong
///         (2)
std::optional<int> read_sweep_arguments(int argc, char** argv, char const* name, char const* meaning,
                                        SweepArguments& arguments);
/// The plan that they make; the folder is the scene's name beside it unless one is given.
/// @throws SceneError
scene::SweepPlan sweep_plan(SweepArguments const& arguments);

}  // namespace actio::app
