#include <Eigen/Core>

#include "program/systems/sphere/input.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "actio/numbers/nearest_name.hpp"
#include "program/systems/sphere/named_states.hpp"

namespace actio::scene {
namespace {

/// The state that the scene names, by `state` or by the table of its parameters; empty where it names none.
std::string state_of(SceneTable& initial) {
  auto const names = names_of_states();
  std::vector<std::string> tables;
  for (auto const& key : initial.keys())
    if (std::find(names.begin(), names.end(), key) != names.end()) tables.push_back(key);
  if (tables.size() > 1)
    initial.fail(tables[1], fmt::format("[initial] has '{}' and '{}'; one of them says how the flow begins",
                                        tables[0], tables[1]));
  if (!initial.has("state")) return tables.empty() ? "" : tables[0];
  std::string const name = initial.choice("state", "state", names);
  if (!tables.empty() && tables[0] != name)
    initial.fail(tables[0], fmt::format("[initial.{}] holds parameters of another state than state = \"{}\"",
                                        tables[0], name));
  return name;
}

void read_rows(SceneTable const& initial, sphere::SphereHarmonics& f) {
  auto const rows = initial.rows("harmonics", 4);
  Eigen::MatrixXi lines = Eigen::MatrixXi::Zero(f.degrees(), f.degrees());
  for (std::size_t i = 0; i < rows.size(); ++i) {
    auto const& row = rows[i];
    std::string const wrong =
        put_coefficient(f, lines, -static_cast<int>(i) - 1, row[0], row[1], row[2], row[3]);
    if (!wrong.empty()) throw SceneError(initial.place("harmonics", i), "harmonics: " + wrong);
  }
}

/// The coefficients in the file of the scene.
sphere::SphereHarmonics read_file(SceneTable& initial, int n) {
  auto const [path, text] = initial.read_file("file", "a table of harmonics");
  try {
    return read_harmonics(text, path, n);
  } catch (SceneError const& error) {
    initial.fail("file", std::string("file: ") + error.what());
  }
}

}  // namespace

int read_matrix_size(SceneTable const& system) { return static_cast<int>(system.integer("N", 2, 1L << 20)); }

VorticityStart read_vorticity_start(SceneFile const& file, std::vector<std::string>& remarks) {
  SceneTable system = file.section("system"), initial = file.section("initial");
  VorticityStart start;
  start.n = read_matrix_size(system);
  start.hamiltonian = read_hamiltonian(system);
  if (!system.has("rotation")) system.set("rotation", 0.0);
  start.rotation = system.number("rotation");

  std::string const state = state_of(initial);
  std::vector<std::string> given;
  for (char const* key : {"harmonics", "file"})
    if (initial.has(key)) given.emplace_back(key);
  if (!state.empty()) given.push_back(initial.has("state") ? "state" : state);
  if (given.empty())
    throw SceneError(initial.place(),
                     fmt::format("[initial] needs 'harmonics', rows l, m, re, im; or 'file', a table of "
                                 "such rows; or 'state', one of {}",
                                 listed(names_of_states())));
  if (given.size() > 1)
    initial.fail(given[1], fmt::format("[initial] has '{}' and '{}'; one of them says how the flow begins",
                                       given[0], given[1]));
  start.key = given[0];

  start.relative = sphere::SphereHarmonics(start.n);
  if (given[0] == "harmonics") {
    read_rows(initial, start.relative);
  } else if (given[0] == "file") {
    start.relative = read_file(initial, start.n);
    remarks.emplace_back(
        "file: the copy of the scene names it by its whole path; who repeats or resumes the "
        "run needs it there, as it is now");
  } else {
    initial.set("state", state);
    NamedFlow flow =
        read_named_state(state, {initial.inside(state), start.n, start.hamiltonian, start.rotation,
                                 file.section("scene").integer("seed", 0, std::numeric_limits<long>::max())});
    start.relative = std::move(flow.relative), start.matrix = std::move(flow.matrix);
    return start;
  }
  start.matrix = sphere::matrix_of(start.relative);
  return start;
}

}  // namespace actio::scene
