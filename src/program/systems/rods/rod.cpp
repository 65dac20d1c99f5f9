// A rod that bends, twists, stretches and shears (thesis, chapter 10: rod and shell models).
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "program/registry/companion.hpp"
#include "program/systems/rods/quantities.hpp"
#include "program/systems/rods/snapshots.hpp"

namespace actio::scene {
namespace {

std::vector<Method> methods() {
  return {
      {"multisymplectic",
       {"2"},
       "The discrete field equations on the motions of space, by Cayley's map along the rod and the scheme "
       "of Moser and Veselov in time.",
       "eq_3_11"}};
}

/// Longer steps, where these are stable.
Companion companion_of(Request const& request, RodScene const& scene) {
  auto const& wanted = request.error_estimate;
  bool const asked = wanted.value_or(false);
  // Of companion and control, the latter; a companion of twice the step costs more than half of the run.
  double const longest = scene.longest_step / (asked ? 4 : 6);
  if (!(scene.options.step <= longest))
    return {nullptr, 0, 0, true,
            fmt::format("not estimated: so much longer steps, of which it is made, would not be stable; with "
                        "method.step up to {:.3g} it is",
                        longest)};
  if (wanted && !asked) return {nullptr, 0, 0, true, "left out by output.error_estimate"};
  auto const make = [&](long longer) {
    return std::make_unique<RodMotion>(scene, static_cast<double>(longer) * scene.options.step);
  };
  Companion out = asked ? companions(make, {4, 3, 2}, 2, true) : companions(make, {4, 3}, 2, true);
  out.momentum = "position";
  return out;
}

/// The memory that a run takes at most: what a section takes, measured, of the run and of its companions.
double bytes_of(RodScene const& scene, Request const& request, bool companions) {
  double const each = scene.options.unshearable ? 3400 : 1250;
  return 13.5e6 + (request.snapshots && request.snapshots->in("hdf5") ? 12e6 : 0) +
         static_cast<double>(scene.start.shape.sections()) * each * (companions ? 2.6 : 1);
}

Simulation prepare(Request const& request) {
  RodScene const scene(request, methods());
  Simulation simulation(with_conserved("rod", rod_quantities(), scene.features));
  simulation.remarks = scene.remarks;
  simulation.step = scene.options.step;
  simulation.steps_at_once = std::max(1L, 8192 / static_cast<long>(scene.start.shape.sections()));
  auto const place = [&] { return request.file.section("method").place("step").text() + ": step: "; };
  std::unique_ptr<RodMotion> motion;
  try {
    motion = std::make_unique<RodMotion>(scene, simulation.step);
  } catch (SceneError const&) {
    throw;
  } catch (Error const& error) {
    throw SceneError(request.file.section("system.rod").place(),
                     std::string("[system.rod]: ") + error.what());
  }
  try {
    RodMotion(scene, simulation.step).advance(1);
    simulation.companion = companion_of(request, scene);
  } catch (SceneError const&) {
    throw;
  } catch (Error const& error) {
    simulation.failure = place() + error.what();
  }
  simulation.bytes = bytes_of(scene, request, simulation.companion.motion != nullptr);
  define_rod(simulation.quantities, *motion, scene.longest_step);
  simulation.quantities.ask(request.quantities);
  simulation.snapshots = write_rod(request, scene, *motion);
  simulation.motion = std::move(motion);
  return simulation;
}

}  // namespace

/// A rod.
System rod_system() {
  System out{
      "rod",
      "A rod",
      "A rod that bends, twists, stretches and shears, or only bends and twists: free, held, moved or loaded "
      "at its ends, straight or curved at rest, or a ring.",
      "chapter 10",
      rod_parameters(),
      methods(),
      rod_quantities(),
      prepare,
      "[system]\nkind = \"rod\"\nrod = { length = 1, elements = 20, section = { radius = 0.02, young = 1e6, "
      "poisson = 0.5, density = 1100 } }\nboundary = { start = \"clamped\" }\n"
      "load = { gravity = [0, 0, -9.81] }\n"
      "[run]\nuntil = 2\nevery = 0.01\n[output]\n"
      "quantities = [\"end_place\", \"energy\", \"noether_balance\"]\n"};
  out.snapshots = rod_snapshots();
  return out;
}

}  // namespace actio::scene
