// The ideal fluid on the sphere (thesis, chapter 10): discrete Lie-Poisson on SU(N).
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "actio/quantized_sphere/resolution.hpp"
#include "actio/reduction/composition.hpp"
#include "program/base/memory.hpp"
#include "program/registry/accuracy.hpp"
#include "program/registry/common_keys.hpp"
#include "program/registry/conservation.hpp"
#include "program/systems/method_input.hpp"
#include "program/systems/sphere/input.hpp"
#include "program/systems/sphere/memory.hpp"
#include "program/systems/sphere/quantities.hpp"
#include "program/systems/sphere/snapshots.hpp"

namespace actio::scene {
namespace {

std::vector<Method> methods() {
  return {
      {"all_invariants",
       {"2", "4"},
       "Energy, angular momentum and all Casimir functions at once: the energy-Casimir step, moved along "
       "the coadjoint orbit by what takes energy and angular momentum back. Order 2; composed of substeps "
       "4 (Suzuki). It gives up the Poisson bracket.",
       "claim_10_0_reduced_hydrodynamics"},
      {"energy_casimir",
       {"2", "4"},
       "Energy and all Casimir functions: the stream function is that of the mean of the vorticity before "
       "and after the step. Order 2; composed of substeps 4. On a sphere that rotates it also keeps the "
       "angular momentum about the pole, and so energy and enstrophy relative to the sphere; on one at "
       "rest the angular momentum along the direction that it has at the start. It gives up the Poisson "
       "bracket, and keeps the other components of the angular momentum to the order of the step.",
       "claim_10_0_reduced_hydrodynamics"},
      {"lie_poisson",
       {"2", "4"},
       "The discrete Lie-Poisson algorithm on SU(N) with Cayley's transform, order 2; composed of substeps "
       "4. It keeps the bracket, the angular momentum and all Casimir functions, and the energy to the "
       "order of the step, without a drift.",
       "eq_3_17"},
  };
}

StepKeys const vorticity_step{
    "from the time asked",
    "The time that a step takes, a whole number of times in the time between two rows. By default at "
    "most 0.2 hbar/|P| with the largest eigenvalue of the stream function: then the equation of a step "
    "is solved in few iterations, which from about four times as long on do not converge.",
    "0.01"};
struct PrecisionKeys : KeyTable {
  Key<std::string> precision =
      key("precision", one_of("precision", {"mixed", "double"}), LeftOut{"\"mixed\"; \"double\" for a layer"},
          "How the equation of a step is solved: mixed, mostly in single precision, to about 1e-8 of the "
          "change in a step, or double, to rounding, which takes several times as long. What the method "
          "conserves it conserves to rounding in both, that of the absolute vorticity. Where what turns as a "
          "whole, as the sphere does, has more than 16 times the vorticity of the rest of the flow, the rest "
          "is stepped apart from it, to the rounding of its own and in double precision in either case; a "
          "remark says so. With double a run that goes back returns to where it began. A layer "
          "(system.hamiltonian) takes double alone.",
          "\"double\"");
} const precision_keys{{"method"}};

/// A layer is stepped in double precision: the step in mixed precision is compiled for Euler's fluid and for
/// averaged flow.
bool to_rounding(SceneTable const& method, bool layer) {
  bool const rounding = precision_keys.precision.read_or(method, layer ? "double" : "mixed") == "double";
  if (layer && !rounding)
    precision_keys.precision.fail(
        method,
        "a quasi-geostrophic layer is stepped in double precision; mixed is for Euler's fluid, averaged or "
        "not");
  return rounding;
}

/// What the methods keep.
std::map<std::string, sphere::Conserved> const kept_by{{"all_invariants", sphere::Conserved::all_invariants},
                                                       {"energy_casimir", sphere::Conserved::energy_casimir},
                                                       {"lie_poisson", sphere::Conserved::lie_poisson}};

SphereScheme scheme_of(MethodChoice const& choice, SceneTable const& method, bool layer) {
  return {kept_by.at(choice.name), to_rounding(method, layer),
          choice.number() == 4 ? suzuki<double>() : std::vector<double>{1}};
}

/// The memory that a run takes at most, refused before anything of that size is touched.
double checked_memory(SceneFile const& file, SphereScheme const& scheme,
                      std::vector<std::string> const& quantities) {
  int const n = sphere_keys.N.read(file);
  auto const bytes = [&](int size) {
    return bytes_for_vorticity(size, scheme.fractions.size(), scheme.conserved, scheme.to_rounding,
                               quantities);
  };
  double const needed = bytes(n);
  require_memory(needed, file.section("system").place("N"), fmt::format("N: matrices of the size {}", n),
                 [&](double there) {
                   int const largest = static_cast<int>(n * std::sqrt(there / needed));
                   return fmt::format("N = {} takes {}", largest, bytes_in_words(bytes(largest)));
                 });
  return needed;
}

/// Squares and cubes of the numbers, and what else was asked for, are numbers.
void require_size(SceneTable const& initial, VorticityStart const& start,
                  sphere::SkewHermitian<> const& absolute, bool casimirs) {
  double const largest =
      std::max(absolute.real.cwiseAbs().maxCoeff(), absolute.imaginary.cwiseAbs().maxCoeff());
  double const most = casimirs ? largest_norm_for_casimirs / start.n : 1e90, least = 1e-90;
  if (largest == 0 || (largest >= least && largest <= most)) return;
  initial.fail(
      start.key,
      fmt::format("{}: the vorticity is {} than {}; with a vorticity of about {} {} no number of 64 bits; "
                  "another unit of time makes it moderate",
                  start.key, largest > most ? "larger" : "smaller", largest > most ? most : least, largest,
                  casimirs && largest > most ? "casimirs_8 would be" : "its powers would be"));
}

/// What can be trusted: interactions of waves are those of the sphere up to this. What turns as a whole, the
/// degree 1, does so exactly.
std::string resolution(sphere::SphereHarmonics relative, SphereHamiltonian const& hamiltonian) {
  // With these coefficients Euler's fluid has the energy of the flow.
  for (int l = 1; l < relative.degrees(); ++l)
    relative.coefficient.row(l) *= std::sqrt(l * (l + 1.0) / hamiltonian.divisor(l));
  sphere::Resolution const told = sphere::resolution_of(relative);
  if (!(told.energy_degree > 0)) return "";
  return fmt::format(
      "resolution: the energy, a rigid rotation aside, is around the degree {:.0f}, where the "
      "bracket of the matrices is that of the sphere to about {:.1g} (l^4/(6 N^2)); from about the "
      "degree {:.0f} on it is another one",
      told.energy_degree, told.error, told.lost_degree);
}

/// What the user of a scene might want to know of it.
void tell(Simulation& simulation, VorticityStart const& start, SphereFlow const& flow, bool histogram) {
  if (std::string const told = resolution(start.relative, start.hamiltonian); !told.empty())
    simulation.remarks.push_back(told);
  if (start.hamiltonian.layer())
    simulation.remarks.push_back(
        "a quasi-geostrophic layer is stepped in double precision, which takes several times as "
        "long as the steps of Euler's fluid");
  double const length = start.hamiltonian.length;
  if (start.hamiltonian.averaged() && length * start.n < 1)
    simulation.remarks.push_back(
        fmt::format("averaging: a length of {} is not resolved with N = {}; the flow is Euler's, but that "
                    "the velocity of the finest degree is {:.2g} times as large",
                    length, start.n, (start.n - 1.0) * start.n / start.hamiltonian.divisor(start.n - 1)));
  if (!histogram) return;
  HistogramBins const bins = histogram_bins(flow);
  simulation.remarks.push_back(fmt::format("histogram: {} bins of the width {} from {} to {}", bins.count,
                                           bins.width(), bins.lowest, bins.highest));
}

Simulation prepare(Request const& request) {
  SceneTable const initial = request.file.section("initial"), method = request.file.section("method");
  auto const asked = [&](char const* name) {
    return std::find(request.quantities.begin(), request.quantities.end(), name) != request.quantities.end();
  };
  MethodChoice const choice = read_method(method, methods());
  SphereScheme const scheme = scheme_of(choice, method, read_hamiltonian(request.file).layer());
  double const bytes = checked_memory(request.file, scheme, request.quantities);

  Simulation simulation(with_conserved("vorticity_sphere", vorticity_quantities()));
  VorticityStart start = read_vorticity_start(request.file, simulation.remarks);
  require_size(initial, start,
               start.matrix + sphere::planetary_vorticity(sphere::QuantizedSphere(start.n), start.rotation),
               asked("casimirs"));
  auto const flow = std::make_shared<SphereFlow const>(start.hamiltonian, start.rotation, start.matrix,
                                                       scheme.conserved, simulation.remarks);
  start.matrix = {};
  tell(simulation, start, *flow, asked("histogram"));
  MakeStepped const make = [flow, scheme](double step) { return stepped_vorticity(flow, scheme, step); };
  simulation.step = step_of_scheme(method, request.schedule, flow->fastest_turning(), scheme, make);
  simulation.work = static_cast<double>(scheme.fractions.size());
  simulation.steps_at_once = steps_in_5_ms(start.n, scheme.fractions.size());
  auto motion = stepped_vorticity(flow, scheme, simulation.step);
  simulation.companion = companion_of_scheme(make, choice.number(), simulation.step, request.error_estimate);
  define_vorticity(simulation.quantities, *motion, flow);
  simulation.quantities.ask(request.quantities);
  simulation.snapshots = write_vorticity(request, start.n, start.hamiltonian, *motion);
  simulation.bytes = bytes, simulation.part_bytes = bytes_dealt(start.n);
  simulation.motion = std::move(motion), simulation.on_ranks = true;
  return simulation;
}

}  // namespace

/// The ideal fluid on the sphere.
System vorticity_sphere_system() {
  return {"vorticity_sphere",
          "Ideal fluid on the sphere",
          "The vorticity of an incompressible fluid without friction on a rotating sphere of "
          "unit radius, or the potential vorticity of a quasi-geostrophic layer, or that of averaged "
          "flow, as a matrix of the size N whose spectrum stays.",
          "chapter 10",
          records_of({vorticity_parameters(), vorticity_step, precision_keys, symbol_keys, accuracy_keys}),
          methods(),
          vorticity_quantities(),
          prepare,
          R"([system]
kind = "vorticity_sphere"
N = 32
rotation = 1.0
[initial]
harmonics = [[5, 3, 0.2, 0.1], [3, 1, 0.5, 0.0], [1, 0, 0.5, 0.0]]
[run]
until = 12
every = 0.1
[output]
quantities = ["energy", "angular_momentum", "casimirs"]
)",
          nullptr,
          {},
          nullptr,
          vorticity_snapshots(),
          SnapshotMaps{"vorticity", vorticity_map, vorticity_maps_json}};
}

}  // namespace actio::scene
