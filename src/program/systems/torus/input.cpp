#include "program/systems/torus/input.hpp"

#include <fmt/format.h>

#include <cmath>

#include "program/registry/common_keys.hpp"
#include "program/systems/formula.hpp"
#include "program/systems/sphere/flow_input.hpp"
#include "program/systems/torus/named_states.hpp"

namespace actio::scene {
namespace {

/// How a flow begins.
struct TorusStartKeys : KeyTable {
  AnyKey vorticity =
      key("vorticity", "a text, a formula in x and y", LeftOut{"or initial.file or initial.state"},
          "The vorticity, 1/time, at the point x, y, each from 0 to 2 pi, where it begins again. It is taken "
          "with the wave numbers up to (N - 1)/2 and without its mean; a remark says what was left out.",
          "\"sin(x) + cos(2*y)\"");
  AnyKey file = key(
      "file", "a text, the path of a file beside the scene", LeftOut{"or initial.vorticity or initial.state"},
      "The Fourier coefficients of the vorticity, of exp(i(m x + n y)), as a file with the heading "
      "m,n,re,im, as snapshots write it: n > 0, or n = 0 and m > 0; the others follow, since the "
      "field is real. What is not there is zero.",
      "\"coefficients.csv\"");
  Key<std::string> state =
      key("state", one_of("state", names_of_torus_states()), other_torus_start,
          "A flow by its name; its parameters are in a table of that name, for instance [initial.random] "
          "with last = 10, and where there is such a table it names the state.",
          "\"random\"");
} const torus_start_keys{{"initial"}};

/// Beyond these gamma is no more than rounding beside the Laplacian, or the other way round.
constexpr double least_radius = 1e-3, largest_radius = 1e3;

torus::TorusHarmonics read_formula(SceneTable const& initial, int n, std::vector<std::string>& remarks) {
  std::string const name = torus_start_keys.vorticity.name(), text = initial.formula(name);
  Tape const tape = scene_formula(text, {"x", "y"}, {}, initial.text_place(name), name, for_values).value;
  std::vector<double> work;
  double square = 0, sum = 0;
  auto f = harmonics_of_function(n, [&](double x, double y) {
    double const at[] = {x, y};
    double value;
    tape(at, &value, work);
    if (!std::isfinite(value))
      initial.fail(name, fmt::format("{}: a finite number is expected, found {} at x = {}, y = {}", name,
                                     std::isnan(value) ? std::abs(value) : value, x, y));
    sum += value, square += value * value;
    return value;
  });
  double const points = 4.0 * n * n, all = square / points, mean = sum / points;
  double held = 0;
  for (int m = -f.largest(); m <= f.largest(); ++m)
    for (int k = -f.largest(); k <= f.largest(); ++k) held += std::norm(f(m, k));
  if (std::abs(mean) > 1e-12 * std::sqrt(all))
    remarks.push_back(fmt::format(
        "vorticity: its mean {:.3g} is left out, as the mean of a vorticity on the torus is zero", mean));
  double const lost = std::max(0.0, all - mean * mean - held) / all;
  if (lost > 1e-6)
    remarks.push_back(
        fmt::format("vorticity: wave numbers above {} hold {:.2g} of the mean square of the formula; "
                    "they are left out",
                    f.largest(), lost));
  return f;
}

}  // namespace

std::vector<Parameter> torus_parameters() {
  return records_of({torus_keys, torus_start_keys, parameters_of_torus_states()});
}

int read_torus_size(SceneFile const& file) {
  int const n = torus_keys.N.read(file);
  if (n % 2 == 0)
    torus_keys.N.fail(file,
                      fmt::format("an odd number is expected, {} or {}, found {}: with an even one the wave "
                                  "number N/2, a checkerboard, would have no partner",
                                  n - 1, n + 1, n));
  return n;
}

double read_torus_gamma(SceneFile const& file) {
  auto const radius = torus_keys.deformation.find(file);
  if (!radius) return 0;
  if (!(*radius >= least_radius && *radius <= largest_radius))
    torus_keys.deformation.fail(
        file,
        fmt::format("a radius from {} to {} is expected, found {}; beyond the greatest the layer is Euler's "
                    "fluid, which a scene without it has",
                    least_radius, largest_radius, *radius));
  return 1 / (*radius * *radius);
}

TorusStart read_torus_start(SceneFile const& file, std::vector<std::string>& remarks) {
  SceneTable initial = file.section("initial");
  TorusStart start;
  start.n = read_torus_size(file);
  start.gamma = read_torus_gamma(file);
  auto const [key, state] = read_flow_source(
      initial, "vorticity", "'vorticity', a formula in x and y; or 'file', a table of coefficients",
      names_of_torus_states(), torus_start_keys.state);
  start.key = key;
  if (key == "vorticity") {
    start.vorticity = read_formula(initial, start.n, remarks);
  } else if (key == "file") {
    start.vorticity = read_flow_file(
        initial, torus_start_keys.file, "a table of Fourier coefficients", remarks,
        [&](auto const& text, auto const& path) { return read_torus_harmonics(text, path, start.n); });
  } else {
    torus_start_keys.state.write(file, state);
    start.vorticity = read_torus_state(state, {file, start.n, start.gamma, scene_keys.seed.read(file)});
  }
  double const largest = start.vorticity.coefficient.cwiseAbs().maxCoeff(), least = 1e-90, most = 1e30;
  if (largest != 0 && !(largest >= least && largest <= most))
    initial.fail(
        start.key,
        fmt::format("{}: the vorticity is {} than {}; with a vorticity of about {} its powers would be no "
                    "number of 64 bits; another unit of time makes it moderate",
                    start.key, largest > most ? "larger" : "smaller", largest > most ? most : least,
                    largest));
  return start;
}

}  // namespace actio::scene
