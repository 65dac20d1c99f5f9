// Scenes of flows on the sphere, and their tables.
#pragma once

#include <boost/test/unit_test.hpp>

#include <cmath>
#include <stdexcept>

#include "command.hpp"

namespace command {

/// A flow, how it is stepped, and what is wanted of it.
struct Sphere {
  std::string n = "16", rotation = "0.7", method = "all_invariants", order = "2", step = "0.05", until = "2",
              every = "0.5", quantities = "\"energy\"",
              initial =
                  "harmonics = [[2, 1, 0.9, -0.3], [3, 0, -0.5, 0], [4, 3, 0.4, 0.6], [1, 1, 0.2, 0.1]]",
              more = {}, hamiltonian = {};
  std::string text() const {
    return "[system]\nkind = \"vorticity_sphere\"\nN = " + n + "\nrotation = " + rotation + "\n" +
           hamiltonian + "[method]\nname = \"" + method + "\"\norder = " + order + "\n" +
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

inline bool has(std::string const& text, std::string const& part) {
  return text.find(part) != std::string::npos;
}

/// How far a column is from its first value, in units of `size`; zero: of that value.
inline double drift(Table const& table, std::string const& column, double size = 0) {
  auto const values = table[column];
  if (size == 0) size = std::abs(values.front());
  double most = 0;
  for (double const x : values) most = std::max(most, std::abs(x - values.front()) / size);
  return most;
}
inline double momentum(Table const& table, std::size_t row) {
  return std::hypot(table["angular_momentum_x"][row], table["angular_momentum_y"][row],
                    table["angular_momentum_z"][row]);
}
inline double momentum_drift(Table const& table) {
  double most = 0;
  for (char const* axis : {"x", "y", "z"})
    most = std::max(most, drift(table, std::string("angular_momentum_") + axis, momentum(table, 0)));
  return most;
}

/// What a scene is refused with.
inline Outcome refused(Sphere const& scene) {
  Folder const folder;
  return actio({"run", folder.write("sphere.toml", scene.text()), "--dry-run"});
}
inline void check_refused(Sphere const& scene, std::string const& says, int status = 2) {
  auto const outcome = refused(scene);
  BOOST_TEST(outcome.status == status, says << "\n" << outcome.err << outcome.out);
  BOOST_TEST(has(outcome.err, says), "expected '" << says << "', found '" << outcome.err << "'");
}
inline Sphere starting(std::string const& initial) {
  Sphere scene;
  scene.initial = initial;
  return scene;
}

}  // namespace command
