// A Lagrangian of one's own on a group (thesis, chapters 2 to 4): the Euler-Poincare equations, with carried
// vectors.
#include <fmt/format.h>

#include "actio/reduction/composition.hpp"
#include "program/registry/accuracy.hpp"
#include "program/registry/common_keys.hpp"
#include "program/registry/companion.hpp"
#include "program/systems/lagrangians/casimirs.hpp"
#include "program/systems/lagrangians/constrained_input.hpp"
#include "program/systems/lagrangians/constrained_motion.hpp"
#include "program/systems/lagrangians/force_input.hpp"
#include "program/systems/lagrangians/instruments.hpp"
#include "program/systems/lagrangians/motion.hpp"
#include "program/systems/lagrangians/pace.hpp"
#include "program/systems/lagrangians/quantities.hpp"
#include "program/systems/lagrangians/state.hpp"
#include "program/systems/method_input.hpp"

namespace actio::scene {
namespace {

StepKeys const reduced_step{
    "from the time asked",
    "The time that a step takes, a whole number of times in the time between two rows. By "
    "default a twentieth of the shortest time in which something changes at the start: the "
    "group turns, or the linearized equations of motion swing or grow; a hundredth of the time "
    "between two rows where nothing does.",
    "0.01"};

std::vector<Method> methods() {
  return {
      {"natural_chart",
       {"2", "4", "6"},
       "The natural chart (3.25), order 2: over a step the group moves by exp(h v), and vectors are taken "
       "at both ends; composed of substeps 4 (Suzuki) and 6 (Kahan and Li). It preserves the coadjoint "
       "orbit and the bracket, and conserves the momentum of the symmetry.",
       "eq_3_26"},
      {"cayley_chart",
       {"2", "4", "6"},
       "The same with Cayley's transform for the exponential, order 2: over a step the group moves by (1 - "
       "hv/2)^-1 (1 + hv/2); composed of substeps 4 and 6. On groups into which that transform maps.",
       "eq_3_20"},
      {"galerkin",
       {"4", "2", "6", "8", "10", "12", "14", "16"},
       "Galerkin's method with s nodes of Gauss, order 2s: paths are polynomials in the natural chart. It "
       "preserves and conserves what the natural chart does.",
       "eq_3_20"},
      {"momentum_level",
       {"8"},
       "An explicit method of order 8 (Fehlberg) for the configuration, on a level of the momentum "
       "of the symmetry: that momentum and every Casimir are conserved to rounding, as the natural chart "
       "does. It does not preserve the bracket, and nothing bounds the error of the energy over long times; "
       "of all methods it takes the least time for an error below 1e-6.",
       "rem_3_1_3"}};
}

bool asked(Request const& request, std::initializer_list<char const*> names) {
  for (auto const& name : request.quantities)
    for (char const* const one : names)
      if (name == one) return true;
  return false;
}

ReducedScheme scheme_of(Request const& request, ReducedScene const& scene) {
  SceneTable method = request.file.section("method");
  MethodChoice const choice = read_method(method, methods());
  int const order = choice.number();
  bool const galerkin = choice.name == "galerkin";
  if (scene.system->force && choice.name == "momentum_level")
    method.fail(
        "name",
        "momentum_level: it takes no force, which leads the momentum away from its level; natural_chart, "
        "cayley_chart and galerkin do");
  if (scene.system->force && scene.system->force->across && galerkin)
    method.fail("name", "galerkin: it takes no force_in_space; natural_chart and cayley_chart do");
  bool const left = scene.system->side == systems::Side::left;
  if (scene.constraints && (galerkin || choice.name == "momentum_level"))
    method.fail("name", fmt::format("{}: it takes no constraints on the velocity; natural_chart does, and "
                                    "cayley_chart where it serves the group",
                                    choice.name));
  return {scene.system,
          galerkin ? order / 2 : 0,
          choice.name == "momentum_level" ? std::vector<double>{}
          : order == 2                    ? std::vector<double>{1}
          : order == 4                    ? suzuki<double>()
                                          : kahan_li<double>(),
          asked(request, {"configuration", "contact", "impulse", "momentum_balance",
                          left ? "spatial_momentum" : "body_momentum"}),
          choice.name,
          scene.constraints,
          !scene.constraints || !constraints_move(scene),
          conserves_energy(method, choice.name, scene),
          asked(request, {"work", "impulse", "momentum_balance"}),
          carried_names(request.file)};
}

/// Of a step, as `Simulation` has it: substeps; stages, whose equations are solved together.
double work_of_step(ReducedScheme const& scheme) {
  if (scheme.stages > 0) return std::pow(scheme.stages, 1.5);
  return static_cast<double>(std::max(std::size_t{1}, scheme.fractions.size()));
}

/// The step of the scene. By default it follows the pace of the start, and is halved until a step can be
/// made.
double step_of(Request const& request, ReducedScheme const& scheme, ReducedScene const& scene) {
  SceneTable method = request.file.section("method");
  bool const given = method.has("step");
  double const divisor = request.schedule.common_divisor(), until = request.schedule.until(),
               time = divisor > 1e-3 * until ? divisor : until;
  double fastest = given ? 1 : fastest_rate(scene, time);
  if (!(fastest * time > 1e-12)) fastest = 5 / time;
  double step = read_step(method, request.schedule, fastest);
  for (int k = 0; !given && k < 20; ++k) try {
      scheme.motion(step, scene.start, scene.velocity, scene.configuration);
      break;
    } catch (Error const&) {
      method.set("step", step /= 2);
    }
  return step;
}

Companion companion_of(Request const& request, ReducedScheme const& scheme, ReducedScene const& scene,
                       double step) {
  bool const follows = scheme.with_configuration;
  if (!request.error_estimate.value_or(true))
    return {nullptr, 0, 0, follows, "left out by output.error_estimate"};
  int const order = static_cast<int>(request.file.section("method").integer("order", 2, 16));
  Companion out = companions(
      [&](long multiple) {
        return scheme.motion(static_cast<double>(multiple) * step, scene.start, scene.velocity,
                             scene.configuration);
      },
      {4, 3, 2}, order, follows);
  out.turn = "configuration", out.unit = "", out.vectors = !scene.carried.empty();
  if (asked(request, {"tangent_map"})) out.without = {"tangent_map"};
  return out;
}

/// Refuses momentum_balance where carried vectors break the whole symmetry.
void require_symmetry(Request const& request, ReducedScene const& scene) {
  if (asked(request, {"momentum_balance"}) && conserved_directions(scene).empty())
    request.file.section("output").fail(
        "quantities",
        "momentum_balance: every direction of the basis changes a carried vector, so that it has no "
        "component");
}

/// A composition has substeps backwards, in which damping feeds energy in.
void require_short_for_damping(SceneTable const& method, ReducedScheme const& scheme,
                               Simulation& simulation) {
  auto const& friction = scheme.system->dissipation;
  if (!friction || friction->kind != systems::Dissipation::Kind::conformal || scheme.fractions.size() < 2 ||
      (!scheme.constraints && systems::damps_along_free_motion(*scheme.system)))
    return;
  double const decay = friction->rate * simulation.step;
  if (decay >= 2)
    method.fail("step",
                fmt::format("{}: over a step the damping is {:.3g} times the step, and the composition of "
                            "order 4 or 6 needs less than 2; method.order = 2 takes any",
                            simulation.step, decay));
  if (decay > 0.5)
    simulation.remarks.push_back(fmt::format(
        "damping times step is {:.3g}: the substeps backwards feed energy in; up to 0.5 the order is seen",
        decay));
}

/// Refuses quantities that belong to constraints, to systems without them, or to motions without friction.
void require_quantities(Request const& request, ReducedScene const& scene) {
  SceneTable const output = request.file.section("output");
  for (char const* const name : {"reaction", "constraint"})
    if (!scene.constraints && asked(request, {name}))
      output.fail("quantities", fmt::format("{}: it is a quantity of systems with system.constraints", name));
  if (scene.contact.empty() && asked(request, {"contact"}))
    output.fail("quantities", "contact: it is a quantity of systems with system.contact");
  for (char const* const name : {"impulse", "momentum_balance"})
    if (request.file.section("method").has("conserve") && asked(request, {name}))
      output.fail(
          "quantities",
          fmt::format("{}: it is that of reactions at the times between steps, and those of steps with "
                      "method.conserve act in their middle",
                      name));
  for (char const* const name :
       {"poisson_defect", "symplectic_defect", "leaf_defect", "order", "tangent_map"}) {
    if (!asked(request, {name})) continue;
    if (scene.system->force && scene.system->force->across)
      output.fail("quantities",
                  fmt::format("{}: with force_in_space a step is no map of momenta, since it depends on the "
                              "configuration; momentum_balance is told",
                              name));
    if (scene.system->dissipation)
      output.fail("quantities", fmt::format("{}: it is known of motions without system.dissipation", name));
    if (scene.constraints)
      output.fail("quantities",
                  fmt::format("{}: constraints on the velocity leave no bracket and no two-form "
                              "that steps could preserve; 'constraint' and 'energy' are told",
                              name));
  }
}

Simulation prepare(Request const& request) {
  std::vector<std::string> remarks;
  ReducedScene const scene = read_reduced_scene(request.file, remarks);
  require_symmetry(request, scene);
  SceneTable method = request.file.section("method");
  require_quantities(request, scene);
  ReducedScheme const scheme = scheme_of(request, scene);
  Simulation simulation(quantities_of(request.file, scene));
  simulation.remarks = remarks;
  simulation.step = step_of(request, scheme, scene);
  simulation.work = work_of_step(scheme);
  simulation.steps_at_once = std::max(1L, 4000L / (scene.system->dimension() * scene.system->dimension()));
  require_short_for_damping(method, scheme, simulation);
  std::unique_ptr<ReducedMotion> motion;
  try {
    motion = scheme.motion(simulation.step, scene.start, scene.velocity, scene.configuration);
  } catch (Error const& error) {
    double const longest =
        scheme.longest_step(simulation.step, request.schedule.common_divisor(), scene.start, scene.velocity);
    if (longest > 0)
      fail_for_long_step(method, request.schedule, StepTooLong(scheme.name, simulation.step, longest));
    simulation.failure = method.place("step").text() + ": " + error.what();
    motion = standing(scene);
  }
  if (simulation.failure.empty())
    simulation.companion = companion_of(request, scheme, scene, simulation.step);
  if (asked(request, {"tangent_map"})) motion = following_tangent(std::move(motion), scheme, simulation.step);
  if (!scheme.with_configuration)
    simulation.shortcuts.push_back("momentum only: no configuration is reconstructed");
  define_state(simulation.quantities, scene, *motion);
  define_casimirs(simulation, request, scene, *motion);
  if (scene.constraints)
    define_constraints(simulation.quantities, scene, *motion);
  else
    define_instruments(simulation.quantities, scheme, simulation.step, *motion);
  simulation.quantities.ask(request.quantities);
  simulation.motion = std::move(motion);
  return simulation;
}

/// The cheapest one that takes what acts on the system.
std::string method_for_accuracy(SceneFile const& file) {
  SceneTable const system = file.section("system");
  bool const free = !force_keys.force.given(system) && !force_keys.force_in_space.given(system) &&
                    !system.has("dissipation") && !system.has("constraints");
  return free ? "momentum_level" : "natural_chart";
}

}  // namespace

/// A Lagrangian of one's own on a group.
System euler_poincare_system() {
  return {
      "euler_poincare",
      "A Lagrangian on a group",
      "Any invariant Lagrangian on any group of matrices: a formula in the velocity, in parameters and in "
      "vectors that the motion carries.",
      "chapters 2 to 4",
      records_of({reduced_parameters(), constrained_method_keys(), reduced_step, accuracy_keys}),
      methods(),
      reduced_quantities(),
      prepare,
      "[system]\nkind = \"euler_poincare\"\ngroup = \"SE(2)\"\nlagrangian = \"(w^2 + v1^2 + c*v2^2)/2\"\n"
      "parameters = { c = 6 }\n[initial]\nvelocity = [0.7, 1.0, 0.2]\n[run]\nuntil = 10\nevery = 0.1\n"
      "[output]\nquantities = [\"body_momentum\", \"energy\"]\n",
      nullptr,
      {},
      named_quantities,
      {},
      {},
      method_for_accuracy};
}

}  // namespace actio::scene
