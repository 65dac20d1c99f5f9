#include "program/systems/lagrangians/force_input.hpp"

#include <fmt/format.h>

#include <cmath>

#include "actio/formula/tape_derivatives.hpp"

namespace actio::scene {
namespace {

/// The formula of each component, and where it stands.
struct Component {
  std::string text = "0";
  std::optional<TextPlace> place = {};
};
std::vector<Component> components_of(SceneTable const& system, AnyKey const& key,
                                     systems::MatrixAlgebra const& algebra) {
  std::vector<Component> out(algebra.components.size());
  if (!key.given(system)) return out;
  if (system.is_table(key.name())) {
    SceneTable const force = key.table(system);
    force.allow(algebra.components);
    for (std::size_t i = 0; i < out.size(); ++i)
      if (auto const& name = algebra.components[i]; force.has(name))
        out[i] = {force.formula(name), force.text_place(name)};
    return out;
  }
  auto const texts = system.formulas(key.name());
  if (texts.size() != out.size())
    key.fail(system, fmt::format("{} formulas are expected, one for each of {}; found {}", out.size(),
                                 fmt::join(algebra.components, ", "), texts.size()));
  for (std::size_t i = 0; i < out.size(); ++i) out[i] = {texts[i], system.text_place(key.name(), i)};
  return out;
}

}  // namespace

std::vector<std::string> names_of_force(systems::MatrixAlgebra const& algebra) {
  std::vector<std::string> names;
  for (auto const& component : algebra.components) names.push_back("p_" + component);
  names.push_back("t");
  return names;
}

std::optional<systems::GeneralizedForce> read_force(SceneFile const& file,
                                                    systems::MatrixAlgebra const& algebra,
                                                    std::vector<std::string> const& carried,
                                                    SharedNames& shared) {
  SceneTable const system = file.section("system");
  bool const in_space = force_keys.force_in_space.given(system);
  if (!force_keys.force.given(system) && !in_space) {
    if (force_keys.inputs.given(system))
      force_keys.inputs.fail(system, "they are given to the force, and there is no system.force");
    return {};
  }
  std::vector<std::string> names = algebra.components;
  names.insert(names.end(), carried.begin(), carried.end());
  for (auto& name : names_of_force(algebra)) names.push_back(std::move(name));
  systems::GeneralizedForce force;
  HeldInputs inputs;
  if (force_keys.inputs.given(system))
    inputs = read_held_inputs(force_keys.inputs.table(system), names, shared);
  names.insert(names.end(), inputs.names.begin(), inputs.names.end());
  force.held = std::move(inputs.values);
  std::set<std::string, std::less<>> used_here;
  auto const read = [&](AnyKey const& key) {
    std::vector<Tape> tapes;
    for (auto const& [text, place] : components_of(system, key, algebra)) {
      auto formula =
          shared.read(text, names, place.value_or(system.text_place(key.name())), key.name(), for_values);
      used_here.merge(formula.used);
      tapes.push_back(std::move(formula.value));
    }
    return joined(tapes);
  };
  force.components = read(force_keys.force);
  if (in_space) force.across = read(force_keys.force_in_space);
  if (!inputs.names.empty()) inputs.require_used(force_keys.inputs.table(system), used_here, "force");
  return force;
}

void require_force(SceneTable const& system, ReducedScene const& scene) {
  if (!scene.system->force) return;
  auto const require = [&](AnyKey const& key, Tape const& components) {
    systems::ReducedSystem alone = *scene.system;
    alone.force->components = components, alone.force->across.reset();
    auto const force = systems::force_at(alone, scene.velocity, scene.start);
    for (std::size_t i = 0; i < force.size(); ++i)
      if (!std::isfinite(force[i]))
        key.fail(system, fmt::format("along {} it is {} at the start, and a finite number is needed",
                                     alone.algebra.components[i], force[i]));
  };
  require(force_keys.force, scene.system->force->components);
  if (scene.system->force->across) require(force_keys.force_in_space, *scene.system->force->across);
}

void require_force_in_space(SceneTable const& system, systems::Side side) {
  auto const& key = force_keys.force_in_space;
  if (!key.given(system)) return;
  if (side == systems::Side::right)
    key.fail(system, "with side = \"right\" the components of force are those of space");
  if (system.has("constraints")) key.fail(system, "it takes no system.constraints; system.force does");
}

}  // namespace actio::scene
