// A rigid body in space, free (thesis, chapter 5) or under a torque.
#include <Eigen/Core>

#include <fmt/format.h>

#include <algorithm>

#include "program/catalogue/body_shape.hpp"
#include "program/pictures/pictures.hpp"
#include "program/registry/accuracy.hpp"
#include "program/registry/conservation.hpp"
#include "program/systems/bodies/free_motion.hpp"
#include "program/systems/bodies/rigid_body_scene.hpp"

namespace actio::scene {
namespace {

std::vector<Method> methods() {
  return {
      {"moser_veselov",
       {"exact", "2", "4", "6", "8", "10"},
       "The scheme of Moser and Veselov, order 2; with modified moments of inertia 4 to 10, or exact.",
       "eq_5_9"},
      {"natural_chart",
       {"2", "4", "6"},
       "The kinetic energy through the natural chart, order 2; composed of substeps 4 "
       "(Suzuki) and 6 (Kahan and Li).",
       "eq_5_4"},
      variational_method("the torque"),
  };
}

struct FreeOrTorquedKeys : KeyTable {
  Key<std::string> name =
      key("name", one_of("method", names_of(methods()), "actio list methods"),
          LeftOut{"\"moser_veselov\"; under a torque \"variational\""},
          "The method that the system is stepped by (actio list methods).", "\"moser_veselov\"");
} const method_keys{{"method"}};
MomentumKeys const momentum_keys{{"initial"}, "The angular momentum at the start, in the frame of the body."};

std::vector<Quantity> quantities() {
  using Kind = Quantity::Kind;
  auto all = turning_body_quantities(true);
  all.push_back(
      Quantity{"energy", Kind::scalar,
               "The kinetic energy, and under a torque the potential energy as well, if it has one; "
               "conserved unless the potential depends on time or a part of the torque has none.",
               "H = \\tfrac12\\langle M, I^{-1}M\\rangle + V(q, t)", "energy", "eq_5_1"}
          .from({"body_momentum", "angular_velocity"}));
  all.push_back(
      Quantity{"casimir", Kind::scalar,
               "The square of the angular momentum, which names the coadjoint orbit; a torque changes it.",
               "C = |M|^2", "(energy x time)^2", "claim_5_3_dual_casimir"}
          .from({"body_momentum"}));
  all.push_back(
      Quantity{"axial_momentum", Kind::scalar,
               "The angular momentum in space about the axis of the torque: the direction to the "
               "centre, or the normal of the orbit; the vertical; the axis of space whose row alone is "
               "in the potential; otherwise the third axis of space. Conserved where turns about that "
               "axis do not change the potential.",
               "\\pi_a = \\langle\\pi, a\\rangle", "energy x time", "claim_5_2_spatial_momentum"}
          .from({"spatial_momentum"}));
  all.push_back(Quantity{
      "jacobi_integral", Kind::scalar,
      "The energy minus the rate of the orbit times the axial momentum, conserved where the direction to "
      "the centre turns; the energy where it does not.",
      "J = H - n\\langle\\pi, a\\rangle", "energy"}
                    .from({"attitude", "body_momentum", "angular_velocity", "axial_momentum"}));
  return all;
}

/// The quantities of a body, under a torque or not: with one the potential looks at the attitude, and not all
/// are conserved.
std::vector<Quantity> quantities_under(std::optional<SceneTorque> const& torque) {
  if (!torque) return with_conserved("rigid_body", quantities());
  std::set<Feature> here{Feature::torque};
  if (torque->depends_on_time()) here.insert(Feature::torque_depends_on_time);
  if (!torque->is_steady()) here.insert(Feature::torque_of_time);
  if (!torque->is_symmetric()) here.insert(Feature::torque_without_axis);
  if (!torque->has_potential()) here.insert(Feature::torque_without_potential);
  auto all = quantities();
  std::ranges::find(all, "energy", &Quantity::name)->needs.emplace_back("attitude");
  return with_conserved("rigid_body", std::move(all), here);
}

/// Sees to it that the angle turned until the end has digits.
void check_phase(RigidBodyScene& scene, SceneTable const& run, double until) {
  double const rounding = std::numeric_limits<double>::epsilon(), angle = until * scene.fastest;
  if (!(angle <= 1 / rounding))
    throw NumericsError(run.place("until").text() +
                        fmt::format(": until: the body turns by as much as {:.3g} rad until then; beyond "
                                    "{:.3g} rad no digit of the angle is left",
                                    angle, 1 / rounding));
  if (angle * rounding > 1e-6)
    scene.remarks.push_back(
        fmt::format("until: the body turns by as much as {:.3g} rad, of which rounding "
                    "leaves an error of about {:.1g} rad",
                    angle, angle * rounding));
}

std::vector<std::string> shortcuts(RigidBodyScene const& scene, bool attitude) {
  std::vector<std::string> lines;
  if (!attitude) lines.push_back("momentum only: no attitude is reconstructed");
  if (scene.is_exact()) {
    if (scene.free.is_sphere())
      lines.push_back("sphere: a steady turn, the momentum stands still in the body");
    else if (scene.free.is_symmetric())
      lines.push_back("axisymmetric body: closed form");
    lines.push_back("exact: rows are evaluated where they are asked for; the step is not used");
  } else if (scene.scheme == RigidBodyScene::Scheme::moser_veselov) {
    lines.push_back("one equation for the whole orbit: no step iterates");
  } else if (scene.has_exact_flow()) {
    lines.push_back("no torque: free motion, exact flow");
  }
  return lines;
}

/// Squares may fall below the smallest numbers where momenta do not.
void remark_on_lost_squares(RigidBodyScene& scene, QuantityGraph const& graph) {
  if (scene.torque) return;
  auto const& M = scene.start.body_momentum.components;
  double const least = std::numeric_limits<double>::min(),
               energy = kinetic_energy(scene.inertia, scene.start.body_momentum);
  for (auto const& [name, value] :
       {std::pair<char const*, double>{"energy", energy}, {"casimir", M.squaredNorm()}})
    if (graph.needed(name) && magnitude(M) > 0 && value < least)
      scene.remarks.push_back(fmt::format("{}: it is below {:.3g}, where digits are lost", name, least));
}

/// Kinetic and potential energy.
struct Energies {
  double kinetic, potential;
};
using Needs = std::span<double const* const>;
/// From body momentum and angular velocity, and from the attitude where there is a torque.
using EnergiesFrom = std::function<Energies(double const* M, double const* w, double const* q)>;

EnergiesFrom energies_of(RigidBodyScene const& scene, TorquedMotion const* motion) {
  return [torque = scene.torque, motion](double const* M, double const* w, double const* q) {
    double const kinetic = (M[0] * w[0] + M[1] * w[1] + M[2] * w[2]) / 2;
    if (!torque) return Energies{kinetic, 0};
    return Energies{kinetic,
                    torque->potential(Eigen::Map<Eigen::Vector4d const>(q), motion ? motion->time() : 0)};
  };
}

void define_energy(QuantityGraph& graph, RigidBodyScene const& scene, EnergiesFrom const& energies) {
  if (!scene.torque) {
    graph.define("energy", {""},
                 [energies](Needs n, double* energy) { *energy = energies(n[0], n[1], nullptr).kinetic; });
    return;
  }
  graph.define(
      "energy", {""},
      [energies](Needs n, double* energy) {
        auto const [kinetic, potential] = energies(n[0], n[1], n[2]);
        *energy = kinetic + potential;
      },
      [energies](Needs n, double const*, std::size_t) {
        auto const [kinetic, potential] = energies(n[0], n[1], n[2]);
        return kinetic + std::abs(potential);
      });
}

/// What goes with the axis of the torque.
void define_about_axis(QuantityGraph& graph, RigidBodyScene const& scene, EnergiesFrom const& energies) {
  Eigen::Vector3d const axis = scene.torque ? scene.torque->axis() : Eigen::Vector3d::UnitZ();
  double const rate = scene.torque ? scene.torque->rate() : 0;
  using ConstVector = Eigen::Map<Eigen::Vector3d const>;
  graph.define(
      "axial_momentum", {""}, [axis](Needs n, double* momentum) { *momentum = axis.dot(ConstVector(n[0])); },
      [inertia = scene.inertia, pace = scene.torque ? scene.fastest : 0](Needs n, double const*,
                                                                         std::size_t) {
        return unit_of_momentum(magnitude(Eigen::Vector3d(ConstVector(n[0]))), inertia, pace);
      });
  graph.define(
      "jacobi_integral", {""},
      [energies, rate](Needs n, double* integral) {
        auto const [kinetic, potential] = energies(n[1], n[2], n[0]);
        *integral = kinetic + potential - rate * *n[3];
      },
      [energies, rate](Needs n, double const*, std::size_t) {
        auto const [kinetic, potential] = energies(n[1], n[2], n[0]);
        return kinetic + std::abs(potential) + std::abs(rate * *n[3]);
      });
}

Simulation prepare(Request const& request) {
  RigidBodyScene scene(request, methods());
  if (scene.is_exact()) check_phase(scene, request.file.section("run"), request.schedule.until());
  Simulation simulation(quantities_under(scene.torque));
  auto [motion, torqued, failure] = motion_of(scene, request.schedule);
  QuantityGraph& graph = simulation.quantities;
  define_turning_body(graph, *motion, scene.inertia);
  auto const energies = energies_of(scene, torqued);
  define_energy(graph, scene, energies), define_about_axis(graph, scene, energies);
  graph.define("casimir", {""}, [](Needs n, double* casimir) {
    *casimir = n[0][0] * n[0][0] + n[0][1] * n[0][1] + n[0][2] * n[0][2];
  });
  graph.ask(request.quantities);
  // A torque looks at the attitude.
  bool const attitude = scene.torque || graph.needed("attitude");
  if (!attitude) motion->leave_attitude_out();

  remark_on_lost_squares(scene, graph);

  simulation.exact = scene.is_exact();
  simulation.failure = failure;
  if (failure.empty() || !scene.torque)
    simulation.companion = companion_of(scene, request.error_estimate, attitude);
  simulation.step = scene.step;
  simulation.work = scene.work();
  if (scene.torque) simulation.steps_at_once = scene.torque->steps_at_once();
  simulation.shortcuts = shortcuts(scene, attitude);
  simulation.remarks = scene.remarks;
  simulation.motion = std::move(motion);
  return simulation;
}

BodyShape shape(SceneFile const& file) {
  SceneTable const system = file.section("system");
  PrincipalInertia const inertia = read_body_or_inertia(system);
  return {inertia,
          body_keys().body.given(file) ? parts_of(*find_body(body_keys().body.read(file)))
                                       : std::vector<BodyShape::Part>{},
          {},
          system.has("torque")};
}

}  // namespace

/// The rigid body in space.
System rigid_body_system() {
  return {"rigid_body",
          "Rigid body",
          "A rigid body that turns about its centre of mass, freely or under a torque: Euler's equations for "
          "the momentum, and the attitude that goes with it.",
          "chapter 5",
          records_of({body_keys(), torque_parameters(), initial_parameters(momentum_keys), method_keys,
                      accuracy_keys}),
          methods(),
          quantities(),
          prepare,
          "[system]\nkind = \"rigid_body\"\ninertia = [1, 2, 3]\n[initial]\n"
          "angular_velocity = [0.1, 2, 0.1]\n[run]\nuntil = 20\nevery = 0.1\n[output]\n"
          "quantities = [\"angular_velocity\", \"energy\"]\n",
          shape,
          {{"polhode", "body_momentum", polhode_picture}}};
}

}  // namespace actio::scene
