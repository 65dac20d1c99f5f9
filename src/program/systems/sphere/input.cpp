#include <Eigen/Core>

#include "program/systems/sphere/input.hpp"

#include "program/registry/common_keys.hpp"
#include "program/systems/sphere/flow_input.hpp"
#include "program/systems/sphere/named_states.hpp"

namespace actio::scene {
namespace {

/// How a flow begins.
struct StartKeys : KeyTable {
  Key<Eigen::MatrixXd> harmonics =
      key("harmonics", rows("a list of rows of four numbers: l, m, re, im", 4).in("1/time"),
          LeftOut{"or initial.file or initial.state"},
          "The coefficients of the vorticity relative to the sphere, in orthonormal complex spherical "
          "harmonics with the Condon-Shortley phase. 0 <= m <= l, 1 <= l < N; those of -m follow, since the "
          "field is real. What is left out is zero.",
          "[[5, 3, 0.2, 0.1], [1, 0, 0.5, 0.0]]");
  AnyKey file = key("file", "a text, the path of a file beside the scene",
                    LeftOut{"or initial.harmonics or initial.state"},
                    "The same as a file with the heading l,m,re,im, as snapshots write it: every order of "
                    "every degree up to the last one.",
                    "\"vorticity.csv\"");
  Key<std::string> state = key(
      "state", one_of("state", names_of_states()), other_start,
      "A flow by its name; its parameters are in a table of that name, for instance [initial.random] with "
      "lmax = 10, and where there is such a table it names the state.",
      "\"random\"");
} const start_keys{{"initial"}};

void read_rows(SceneTable const& initial, sphere::SphereHarmonics& f) {
  auto const rows = start_keys.harmonics.read(initial);
  Eigen::MatrixXi lines = Eigen::MatrixXi::Zero(f.degrees(), f.degrees());
  for (int i = 0; i < rows.rows(); ++i) {
    std::string const wrong =
        put_coefficient(f, lines, -i - 1, rows(i, 0), rows(i, 1), rows(i, 2), rows(i, 3));
    if (!wrong.empty()) start_keys.harmonics.fail_at(initial, static_cast<std::size_t>(i), wrong);
  }
}

}  // namespace

std::vector<Parameter> vorticity_parameters() {
  return records_of({sphere_keys, hamiltonian_keys, start_keys, parameters_of_states()});
}

VorticityStart read_vorticity_start(SceneFile const& file, std::vector<std::string>& remarks) {
  SceneTable initial = file.section("initial");
  VorticityStart start;
  start.n = sphere_keys.N.read(file);
  start.hamiltonian = read_hamiltonian(file);
  start.rotation = sphere_keys.rotation.read(file);

  auto const [key, state] = read_flow_source(
      initial, "harmonics", "'harmonics', rows l, m, re, im; or 'file', a table of such rows",
      names_of_states(), start_keys.state);
  start.key = key;
  start.relative = sphere::SphereHarmonics(start.n);
  if (key == "harmonics") {
    read_rows(initial, start.relative);
  } else if (key == "file") {
    start.relative = read_flow_file(
        initial, start_keys.file, "a table of harmonics", remarks,
        [&](auto const& text, auto const& path) { return read_harmonics(text, path, start.n); });
  } else {
    start_keys.state.write(file, state);
    NamedFlow flow = read_named_state(
        state, {file, start.n, start.hamiltonian, start.rotation, scene_keys.seed.read(file)});
    start.relative = std::move(flow.relative), start.matrix = std::move(flow.matrix);
    return start;
  }
  start.matrix = sphere::matrix_of(start.relative);
  return start;
}

}  // namespace actio::scene
