// A free rigid body in space (thesis, chapter 5).
#include <fmt/format.h>

#include "actio/reduction/composition.hpp"
#include "actio/scene/bodies.hpp"
#include "actio/scene/body_shape.hpp"
#include "actio/scene/pictures.hpp"
#include "actio/scene/systems/free_motion.hpp"
#include "actio/scene/systems/method_input.hpp"

namespace actio::scene {
namespace {

std::vector<Parameter> parameters() {
  std::vector<Parameter> all{
      {"system.body", "a text", "or system.inertia",
       "A body of the library, with its inertia (actio list bodies).", "", "\"apophis\"", names_of_bodies()},
      {"system.inertia", "three numbers, or a symmetric 3 by 3 matrix", "or system.body",
       "The moments of inertia about the centre of mass, along the axes of the body frame, or the tensor in "
       "that frame.",
       "mass x length^2", "[1, 2, 3]"},
  };
  auto const initial = initial_parameters("The angular momentum at the start, in the frame of the body.");
  all.insert(all.end(), initial.begin(), initial.end());
  return all;
}

std::vector<Method> methods() {
  return {
      {"moser_veselov",
       {"exact", "2", "4", "6", "8", "10"},
       "The scheme of Moser and Veselov, order 2; with modified moments of inertia 4 to 10, or exact.",
       "eq_5_9"},
      {"natural_chart",
       {"2", "4", "6"},
       "The kinetic energy through the natural chart, order 2; composed of substeps 4 (Suzuki) and 6 (Kahan "
       "and Li).",
       "eq_5_4"},
  };
}

std::vector<Quantity> quantities() {
  using Kind = Quantity::Kind;
  auto all = turning_body_quantities(true);
  all.push_back({"energy",
                 Kind::scalar,
                 "The kinetic energy.",
                 "H = \\tfrac12\\langle M, I^{-1}M\\rangle",
                 "energy",
                 "eq_5_1",
                 {"body_momentum", "angular_velocity"},
                 true});
  all.push_back({"casimir",
                 Kind::scalar,
                 "The square of the angular momentum, which names the coadjoint orbit.",
                 "C = |M|^2",
                 "(energy x time)^2",
                 "claim_5_3_dual_casimir",
                 {"body_momentum"},
                 true});
  return all;
}

/// What a scene says of a free body.
struct FreeBodyScene {
  SceneTable system, initial, method;
  std::vector<std::string> remarks;
  PrincipalInertia inertia;
  FreeState start;
  FreeBody body;
  MethodChoice choice;
  double fastest, step;

  explicit FreeBodyScene(Request const& request)
      : system(request.file.section("system")),
        initial(request.file.section("initial")),
        method(request.file.section("method")),
        inertia(read_body_or_inertia(system)),
        start(read_start(initial, inertia, remarks)),
        body(inertia, start.body_momentum, start.attitude),
        choice(read_method(method, methods())),
        fastest(fastest_turn(inertia, kinetic_energy(inertia, start.body_momentum))),
        step(read_step(method, request.schedule, fastest)) {}
};

/// Sees to it that the angle turned until the end has digits.
void check_phase(FreeBodyScene& scene, SceneTable const& run, double until) {
  double const rounding = std::numeric_limits<double>::epsilon(), angle = until * scene.fastest;
  if (!(angle <= 1 / rounding))
    throw NumericsError(run.place("until").text() +
                        fmt::format(": until: the body turns by as much as {:.3g} rad until then; beyond "
                                    "{:.3g} rad no digit of the angle is left",
                                    angle, 1 / rounding));
  if (angle * rounding > 1e-6)
    scene.remarks.push_back(
        fmt::format("until: the body turns by as much as {:.3g} rad, of which rounding leaves an error of "
                    "about {:.1g} rad",
                    angle, angle * rounding));
}

std::unique_ptr<TurningBody> motion_of(FreeBodyScene const& scene, Schedule const& schedule) {
  int const order = scene.choice.number();
  PrincipalInertia const& inertia = scene.inertia;
  try {
    if (order == 0) return exact_motion(scene.body);
    if (scene.choice.name == "natural_chart") {
      auto const fractions = order == 2   ? std::vector<double>{1}
                             : order == 4 ? suzuki<double>()
                                          : kahan_li<double>();
      auto const steps = [=](FreeState const& start, double h) {
        return NaturalChartSteps(inertia, start.body_momentum, start.attitude, h, fractions);
      };
      return stepped_motion(StepsFrom<NaturalChartSteps>(steps), scene.start, scene.step);
    }
    auto const steps = [=](FreeState const& start, double h) {
      FreeBody const body(inertia, start.body_momentum, start.attitude);
      return FreeSteps(body, h, body.moser_veselov_parameters(h, order));
    };
    return stepped_motion(StepsFrom<FreeSteps>(steps), scene.start, scene.step);
  } catch (StepTooLong const& error) {
    fail_for_long_step(scene.method, schedule, error);
  } catch (Error const& error) {
    throw NumericsError(scene.method.place("step").text() + ": " + error.what());
  }
}

/// The true motion, beside a run in steps: it takes as long as some fifty steps, and one row in sixteen is
/// compared.
Companion companion_of(FreeBodyScene const& scene, std::optional<bool> wanted, bool attitude) {
  if (scene.choice.order == "exact") return {nullptr, 0, 0, attitude, "exact: no error but that of rounding"};
  if (!wanted.value_or(true)) return {nullptr, 0, 0, attitude, "left out by output.error_estimate"};
  auto exact = exact_motion(scene.body);
  if (!attitude) exact->leave_attitude_out();
  return {std::move(exact), 0, scene.choice.number(), attitude, "compared with the exact motion"};
}

std::vector<std::string> shortcuts(FreeBodyScene const& scene, bool attitude) {
  std::vector<std::string> lines;
  if (!attitude) lines.push_back("momentum only: no attitude is reconstructed");
  if (scene.choice.order == "exact") {
    if (scene.body.is_sphere())
      lines.push_back("sphere: a steady turn, the momentum stands still in the body");
    else if (scene.body.is_symmetric())
      lines.push_back("axisymmetric body: closed form");
    lines.push_back("exact: rows are evaluated where they are asked for; the step is not used");
  } else if (scene.choice.name == "moser_veselov") {
    lines.push_back("one equation for the whole orbit: no step iterates");
  }
  return lines;
}

/// Squares may fall below the smallest numbers where momenta do not.
void remark_on_lost_squares(FreeBodyScene& scene, QuantityGraph const& graph) {
  auto const& M = scene.start.body_momentum.components;
  double const least = std::numeric_limits<double>::min(),
               energy = kinetic_energy(scene.inertia, scene.start.body_momentum);
  for (auto const& [name, value] :
       {std::pair<char const*, double>{"energy", energy}, {"casimir", M.squaredNorm()}})
    if (graph.needed(name) && magnitude(M) > 0 && value < least)
      scene.remarks.push_back(fmt::format("{}: it is below {:.3g}, where digits are lost", name, least));
}

Simulation prepare(Request const& request) {
  FreeBodyScene scene(request);
  if (scene.choice.order == "exact")
    check_phase(scene, request.file.section("run"), request.schedule.until());
  Simulation simulation(quantities());
  std::unique_ptr<TurningBody> motion;
  try {
    motion = motion_of(scene, request.schedule);
  } catch (NumericsError const& error) {
    // The start can still be told.
    simulation.failure = error.what();
    motion = exact_motion(scene.body);
  }
  QuantityGraph& graph = simulation.quantities;
  define_turning_body(graph, *motion, scene.inertia);
  graph.define("energy", {""}, [](auto needs, double* energy) {
    *energy = (needs[0][0] * needs[1][0] + needs[0][1] * needs[1][1] + needs[0][2] * needs[1][2]) / 2;
  });
  graph.define("casimir", {""}, [](auto needs, double* casimir) {
    *casimir = needs[0][0] * needs[0][0] + needs[0][1] * needs[0][1] + needs[0][2] * needs[0][2];
  });
  graph.ask(request.quantities);
  bool const attitude = graph.needed("attitude");
  if (!attitude) motion->leave_attitude_out();

  remark_on_lost_squares(scene, graph);

  simulation.exact = scene.choice.order == "exact";
  simulation.companion = companion_of(scene, request.error_estimate, attitude);
  simulation.step = scene.step;
  simulation.shortcuts = shortcuts(scene, attitude);
  simulation.remarks = scene.remarks;
  simulation.motion = std::move(motion);
  return simulation;
}

BodyShape shape(SceneFile const& file) {
  SceneTable const system = file.section("system");
  PrincipalInertia const inertia = read_body_or_inertia(system);
  return {inertia,
          system.has("body") ? parts_of(*find_body(system.text("body"))) : std::vector<BodyShape::Part>{}};
}

}  // namespace

/// The free rigid body in space.
System rigid_body_system() {
  return {"rigid_body",
          "Free rigid body",
          "A rigid body that turns freely about its centre of mass: Euler's equations for the momentum, and "
          "the attitude that goes with it.",
          "chapter 5",
          parameters(),
          methods(),
          quantities(),
          prepare,
          "[system]\nkind = \"rigid_body\"\ninertia = [1, 2, 3]\n[initial]\nangular_velocity = [0.1, 2, "
          "0.1]\n[run]\nuntil = 20\nevery = 0.1\n[output]\nquantities = [\"angular_velocity\", \"energy\"]\n",
          shape,
          {{"polhode", "body_momentum", polhode_picture}}};
}

}  // namespace actio::scene
