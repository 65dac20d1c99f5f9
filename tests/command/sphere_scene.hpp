// Scenes of flows on the sphere, and their tables.
#pragma once

#include <stdexcept>

#include "command.hpp"

namespace command {

/// A flow, how it is stepped, and what is wanted of it.
struct Sphere {
  std::string n = "16", rotation = "0.7", method = "all_invariants", order = "2", step = "0.05", until = "2",
              every = "0.5", quantities = "\"energy\"",
              initial =
                  "harmonics = [[2, 1, 0.9, -0.3], [3, 0, -0.5, 0], [4, 3, 0.4, 0.6], [1, 1, 0.2, 0.1]]",
              more = {};
  std::string text() const {
    return "[system]\nkind = \"vorticity_sphere\"\nN = " + n + "\nrotation = " + rotation +
           "\n[method]\nname = \"" + method + "\"\norder = " + order + "\n" +
           (step.empty() ? "" : "step = " + step + "\n") + "[run]\nuntil = " + until + "\n" +
           (every.empty() ? "" : "every = " + every + "\n") + "[output]\nquantities = [" + quantities +
           "]\n" + more + "[initial]\n" + initial + "\n";
  }
};

/// The table of a scene that runs; what it leaves is in the folder `out`.
inline Table run_in(Folder const& folder, Sphere const& scene, std::vector<std::string> const& more = {}) {
  std::vector<std::string> arguments{"run", folder.write("sphere.toml", scene.text()), "--out",
                                     folder / "out", "--force"};
  arguments.insert(arguments.end(), more.begin(), more.end());
  auto const outcome = actio(arguments);
  if (outcome.status != 0) throw std::runtime_error(outcome.err);
  return read_csv(folder / "out/series.csv");
}
inline Table table_of(Sphere const& scene) {
  Folder const folder;
  return run_in(folder, scene);
}

}  // namespace command
