#include <Eigen/Core>

#include "program/systems/lagrangians/constrained_input.hpp"

#include <fmt/format.h>

#include <random>

#include "actio/nonholonomic/constrained_integrator.hpp"
#include "program/systems/formula.hpp"

namespace actio::scene {
namespace {

struct ConstraintKeys : KeyTable {
  AnyKey constraints =
      key("constraints", "a list of formulas", LeftOut{"none"},
          "What vanishes along the motion, by the principle of Lagrange and d'Alembert: formulas in the "
          "components of the velocity, linear in them, in parameters, components of carried vectors and the "
          "time t. A blade that does not slip, a ball that rolls.",
          "[\"v2 - 0.2*v1\"]");
} const keys{{"system"}};

struct ConstrainedStartKeys : KeyTable {
  Key<bool> project = key(
      "project", truth, false,
      "Whether a velocity at the start that breaks system.constraints is moved on them, as by the blow that "
      "makes a body roll; otherwise it is refused.",
      "true");
} const start_keys{{"initial"}};

/// How far a velocity may break a constraint without being moved, relative to what that is of a velocity of
/// this size.
constexpr double allowed = 1e-6;

}  // namespace

KeyTable const& constraint_keys() { return keys; }
KeyTable const& constrained_start_keys() { return start_keys; }

std::vector<Tape> read_constraints(SceneTable const& system, std::vector<std::string> names,
                                   std::map<std::string, double> const& parameters,
                                   std::set<std::string, std::less<>>& used) {
  std::vector<Tape> all;
  if (!keys.constraints.given(system)) return all;
  if (parameters.contains("t"))
    system.inside("parameters")
        .fail("t", "the name 't' is taken already: in system.constraints it is the time");
  names.push_back("t");
  auto const texts = system.texts("constraints");
  if (texts.empty()) keys.constraints.fail(system, "at least one formula is expected");
  for (std::size_t k = 0; k < texts.size(); ++k) {
    auto formula =
        scene_formula(texts[k], names, parameters, system.text_place("constraints", k), "constraints");
    used.merge(formula.used);
    all.push_back(std::move(formula.value));
  }
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
