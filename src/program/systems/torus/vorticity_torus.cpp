// The ideal fluid on the flat torus (thesis, chapter 10): discrete Lie-Poisson on SU(N).
#include <Eigen/Core>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "actio/quantized_torus/torus_invariants.hpp"
#include "actio/reduction/composition.hpp"
#include "program/base/memory.hpp"
#include "program/registry/accuracy.hpp"
#include "program/registry/common_keys.hpp"
#include "program/registry/conservation.hpp"
#include "program/systems/method_input.hpp"
#include "program/systems/sphere/memory.hpp"
#include "program/systems/sphere/products.hpp"
#include "program/systems/torus/input.hpp"
#include "program/systems/torus/quantities.hpp"
#include "program/systems/torus/snapshots.hpp"

namespace actio::scene {
namespace {

std::vector<Method> torus_methods() {
  return {
      {"energy_casimir",
       {"2", "4"},
       "Energy and all Casimir functions: the stream function is that of the mean of the vorticity before "
       "and after the step. Order 2; composed of substeps 4 (Suzuki). It gives up the Poisson bracket.",
       "claim_10_0_reduced_hydrodynamics"},
      {"lie_poisson",
       {"2", "4"},
       "The discrete Lie-Poisson algorithm on SU(N) with Cayley's transform, order 2; composed of "
       "substeps 4. It keeps the bracket and all Casimir functions, and the energy to the order of the "
       "step, without a drift.",
       "eq_3_17"},
  };
}

StepKeys const torus_step{
    "from the time asked",
    "The time that a step takes, a whole number of times in the time between two rows. By default at most "
    "0.2 hbar/|P| with the largest eigenvalue of the stream function, hbar = 2 pi/N: then the equation of a "
    "step is solved in few iterations, which from about four times as long on do not converge.",
    "0.01"};
struct TorusPrecisionKeys : KeyTable {
  Key<std::string> precision =
      key("precision", one_of("precision", {"mixed", "double"}), "mixed",
          "How the equation of a step is solved: mixed, mostly in single precision, to about 1e-8 of the "
          "change in a step, or double, to rounding, which takes several times as long. What the method "
          "conserves it conserves to rounding in both. With double a run that goes back returns to where "
          "it began.",
          "\"double\"");
} const torus_precision{{"method"}};

/// What can be trusted: interactions of waves are those of the torus up to this.
std::string torus_resolution(TorusStart const& start) {
  Eigen::VectorXd const energy = torus::energy_by_ring(start.vorticity, start.gamma);
  double const all = energy.sum();
  if (!(all > 0)) return "";
  double ring = 0;
  for (Eigen::Index k = 1; k < energy.size(); ++k) ring += static_cast<double>(k) * energy[k] / all;
  // sin(x)/x is 1 - x^2/6 with x = pi (a x b)/N, and |a x b| about k^2; at x = pi nothing is left.
  double const off = std::min(1.0, std::pow(M_PI * ring * ring / start.n, 2) / 6);
  return fmt::format(
      "resolution: the energy is around the wave number {:.0f}, where the bracket of the matrices is that of "
      "the torus to about {:.1g} (pi^2 k^4/(6 N^2)); from about the wave number {:.0f} on it is another one",
      ring, off, std::sqrt(start.n));
}

Simulation prepare(Request const& request) {
  SceneTable const method = request.file.section("method");
  MethodChoice const choice = read_method(method, torus_methods());
  SphereScheme const scheme{
      choice.name == "lie_poisson" ? sphere::Conserved::lie_poisson : sphere::Conserved::energy_casimir,
      torus_precision.precision.read(method) == "double",
      choice.number() == 4 ? suzuki<double>() : std::vector<double>{1}};
  int const n = read_torus_size(request.file);
  // A few matrices more than on the sphere: transforms of the diagonals.
  auto const bytes = [&](int size) {
    return bytes_for_vorticity(size, scheme.fractions.size(), scheme.conserved, scheme.to_rounding,
                               request.quantities) +
           4.0 * sizeof(double) * size * size;
  };
  require_memory(bytes(n), request.file.section("system").place("N"),
                 fmt::format("N: matrices of the size {}", n), [&](double there) {
                   int const largest = static_cast<int>(n * std::sqrt(there / bytes(n))) / 2 * 2 - 1;
                   return fmt::format("N = {} takes {}", largest, bytes_in_words(bytes(largest)));
                 });

  Simulation simulation(with_conserved("vorticity_torus", torus_quantities()));
  TorusStart const start = read_torus_start(request.file, simulation.remarks);
  auto const flow = std::make_shared<TorusFlow const>(TorusFlow{torus::TorusStream(n, start.gamma),
                                                                torus::matrix_of(start.vorticity),
                                                                products_of_size(n, simulation.remarks)});
  if (std::string const told = torus_resolution(start); !told.empty()) simulation.remarks.push_back(told);
  MakeStepped const make = [flow, scheme](double step) { return stepped_torus(flow, scheme, step); };
  simulation.step = step_of_scheme(method, request.schedule, flow->fastest_turning(), scheme, make);
  simulation.work = static_cast<double>(scheme.fractions.size());
  simulation.steps_at_once = steps_in_5_ms(n, scheme.fractions.size());
  auto motion = stepped_torus(flow, scheme, simulation.step);
  simulation.companion = companion_of_scheme(make, choice.number(), simulation.step, request.error_estimate);
  simulation.bytes = bytes(n), simulation.part_bytes = bytes_dealt(n);
  define_torus(simulation.quantities, *motion, flow);
  simulation.quantities.ask(request.quantities);
  simulation.snapshots = write_torus(request, start.gamma, n, *motion);
  simulation.motion = std::move(motion), simulation.on_ranks = true;
  return simulation;
}

}  // namespace

/// The ideal fluid on the flat torus.
System vorticity_torus_system() {
  return {"vorticity_torus",
          "Ideal fluid on the torus",
          "The vorticity of an incompressible fluid without friction in the plane, periodic with 2 pi "
          "in both directions, or the potential vorticity of a layer with a radius of deformation, as "
          "a matrix of the odd size N whose spectrum stays.",
          "chapter 10",
          records_of({torus_parameters(), torus_step, torus_precision, accuracy_keys}),
          torus_methods(),
          torus_quantities(),
          prepare,
          R"scene([system]
kind = "vorticity_torus"
N = 33
[initial]
vorticity = "cos(x) + cos(2*y) + 0.5*sin(x + y)"
[run]
until = 12
every = 0.1
[output]
quantities = ["energy", "enstrophy", "casimirs"]
)scene",
          nullptr,
          {},
          nullptr,
          torus_snapshots(),
          SnapshotMaps{"vorticity", torus_map, torus_maps_json}};
}

}  // namespace actio::scene
