// Runs of the built commands, timed by their summaries.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <functional>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>

namespace benchmark {

/// A folder among the temporary files, gone at the end.
struct Folder {
  std::string path = (std::filesystem::temp_directory_path() / "actio_runs_XXXXXX").string();
  Folder() {
    if (!::mkdtemp(path.data())) throw std::runtime_error("no folder among the temporary files");
  }
  Folder(Folder const&) = delete;
  Folder& operator=(Folder const&) = delete;
  ~Folder() { std::filesystem::remove_all(path); }
};

/// The command with which so many ranks run, each on a processor of its own.
inline std::string on_ranks(int ranks, std::string const& mpiexec, std::string const& command) {
  ::setenv("OMPI_ALLOW_RUN_AS_ROOT", "1", 1), ::setenv("OMPI_ALLOW_RUN_AS_ROOT_CONFIRM", "1", 1);
  return "taskset -c 0-" + std::to_string(ranks - 1) + " " + mpiexec + " --oversubscribe --bind-to none -n " +
         std::to_string(ranks) + " " + command;
}

/// Wall seconds that twice so many steps take, without what comes before and after them: the difference of
/// two runs, of so many steps and of three times as many, each the least of some rounds.
/// @param command  that runs a scene
/// @param scene    its text, for a number of steps
inline double seconds_of_steps(Folder const& folder, std::string const& command,
                               std::function<std::string(long)> const& scene, long steps, int rounds) {
  auto const run = [&](long count) {
    std::ofstream(folder.path + "/scene.toml") << scene(count);
    double best = HUGE_VAL;
    for (int k = 0; k < rounds; ++k) {
      std::string const line = command + " run " + folder.path + "/scene.toml --force --quiet --out " +
                               folder.path + "/run > " + folder.path + "/told 2>&1";
      if (std::system(line.c_str()) != 0) throw std::runtime_error("a run failed: " + line);
      best = std::min(best,
                      nlohmann::json::parse(std::ifstream(folder.path + "/run/summary.json"))["wall_seconds"]
                          .get<double>());
    }
    return best;
  };
  double const few = run(steps);
  return run(3 * steps) - few;
}

}  // namespace benchmark
