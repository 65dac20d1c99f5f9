#include <Eigen/Core>

#include "program/systems/lagrangians/constrained_input.hpp"

#include <fmt/format.h>

#include <random>

#include "actio/nonholonomic/constrained_integrator.hpp"

namespace actio::scene {
namespace {

struct ConstraintKeys : KeyTable {
  AnyKey constraints =
      key("constraints", "a list of formulas", LeftOut{"none"},
          "What vanishes along the motion, by the principle of Lagrange and d'Alembert: formulas in the "
          "components of the velocity, linear in them, in parameters, components of carried vectors and the "
          "time t. A blade that does not slip, a ball that rolls.",
          "[\"v2 - 0.2*v1\"]");
  AnyKey contact = key(
      "contact", "a list of formulas, one for each direction of space", LeftOut{"none"},
      "On SE(2) and SE(3), with system.constraints: where the body touches, as seen from its origin in its "
      "own frame, in parameters and components of carried vectors. The quantity contact is that place in "
      "space.",
      "[\"0.3\", \"0\"]");
} const keys{{"system"}};

struct ConstrainedStartKeys : KeyTable {
  Key<bool> project = key(
      "project", truth, false,
      "Whether a velocity at the start that breaks system.constraints is moved on them, as by the blow that "
      "makes a body roll; otherwise it is refused.",
      "true");
} const start_keys{{"initial"}};

struct ConstrainedMethodKeys : KeyTable {
  Key<std::string> conserve = key(
      "conserve", one_of("value of conserve", {"energy"}), LeftOut{"what the method conserves"},
      "Of steps with system.constraints in cayley_chart: whether they conserve the energy, to rounding. The "
      "Lagrangian is then a kinetic energy with constant coefficients less a potential. Not the velocities "
      "shown obey the constraints, but those of the steps.",
      "\"energy\"");
} const method_keys{{"method"}};

/// How far a velocity may break a constraint without being moved, relative to what that is of a velocity of
/// this size.
constexpr double allowed = 1e-6;

}  // namespace

KeyTable const& constraint_keys() { return keys; }
KeyTable const& constrained_start_keys() { return start_keys; }
KeyTable const& constrained_method_keys() { return method_keys; }

std::vector<Tape> read_constraints(SceneTable const& system, std::vector<std::string> names,
                                   SharedNames& shared) {
  std::vector<Tape> all;
  if (!keys.constraints.given(system)) return all;
  if (shared.has_parameter("t"))
    system.inside("parameters")
        .fail("t", "the name 't' is taken already: in system.constraints it is the time");
  names.push_back("t");
  auto const texts = system.texts("constraints");
  if (texts.empty()) keys.constraints.fail(system, "at least one formula is expected");
  for (std::size_t k = 0; k < texts.size(); ++k) {
    all.push_back(shared.read(texts[k], names, system.text_place("constraints", k), "constraints").value);
  }
  return all;
}

std::vector<Tape> read_contact(SceneTable const& system, systems::MatrixAlgebra const& algebra,
                               std::vector<std::string> const& vectors, SharedNames& shared) {
  std::vector<Tape> all;
  if (!keys.contact.given(system)) return all;
  if (!keys.constraints.given(system))
    keys.contact.fail(system, "it goes with system.constraints, and there are none");
  bool const motions = algebra.name == "SE(2)" || algebra.name == "SE(3)";
  if (!motions)
    keys.contact.fail(system, "it is a place of a body that moves in the plane or in space, SE(2) or SE(3)");
  auto const texts = system.texts("contact");
  if (static_cast<int>(texts.size()) + 1 != algebra.size)
    keys.contact.fail(system,
                      fmt::format("{} formulas are expected, one for each direction of space; found {}",
                                  algebra.size - 1, texts.size()));
  for (std::size_t k = 0; k < texts.size(); ++k)
    all.push_back(shared.read(texts[k], vectors, system.text_place("contact", k), "contact").value);
  return all;
}

void constrain(SceneFile const& file, std::vector<Tape> const& each, ReducedScene& scene,
               std::vector<std::string>& remarks) {
  SceneTable const system = file.section("system"), initial = file.section("initial");
  bool const project = start_keys.project.read(initial);
  systems::ConstrainedState state;
  try {
    auto const constraints = std::make_shared<systems::VelocityConstraints const>(*scene.system, each);
    scene.constraints = constraints;
    systems::ConstrainedVelocity projection(*scene.system, *constraints);
    projection.require_independent(scene.velocity, scene.start.vectors, 0);
    double const defect = projection.defect(scene.velocity, scene.start.vectors, 0);
    if (defect > allowed && !project)
      initial.fail("velocity",
                   fmt::format("velocity: it breaks system.constraints by {:.3g} of its size, and at most "
                               "{:.0e} is allowed; initial.project = true moves it on them",
                               defect, allowed));
    state = systems::constrained_state(*scene.system, *constraints, scene.velocity, scene.start.vectors, 0,
                                       HUGE_VAL);
  } catch (SceneError const&) {
    throw;
  } catch (Error const& error) {
    keys.constraints.fail(system, error.what());
  }
  if (state.moved > 1e-12)
    remarks.push_back(fmt::format(
        "velocity: it broke the constraints by {:.2g} of its size, and was moved on them", state.moved));
  scene.velocity = state.velocity, scene.start = state.point;
}

bool conserves_energy(SceneTable const& method, std::string const& name, ReducedScene const& scene) {
  auto const& key = method_keys.conserve;
  if (!key.given(method)) return false;
  key.read(method);
  if (!scene.constraints)
    key.fail(method,
             "it is for steps with system.constraints; others have an error of the energy that stays "
             "bounded");
  if (name != "cayley_chart")
    key.fail(method, fmt::format("it needs the chart by Cayley's transform, name = \"cayley_chart\", and the "
                                 "scene has {}",
                                 name));
  try {
    systems::require_constant_metric(*scene.system);
  } catch (Error const& error) {
    key.fail(method, error.what());
  }
  return true;
}

bool constraints_move(ReducedScene const& scene) {
  systems::ConstraintValues<double> at(*scene.constraints);
  std::vector<double> const rest(scene.velocity.size(), 0);
  std::vector<double> a = scene.start.vectors;
  std::mt19937_64 draw(1);
  for (int k = 0; k < 8; ++k) {
    at.set_values(rest, a, k);
    for (double const c : at.values)
      if (c != 0) return true;
    for (double& x : a) x = std::ldexp(static_cast<double>(draw() % 4096) - 2048, -10);
  }
  return false;
}

}  // namespace actio::scene
