#include "program/systems/lagrangians/force_input.hpp"

#include <fmt/format.h>

#include <charconv>
#include <cmath>

#include "actio/formula/tape_derivatives.hpp"

namespace actio::scene {
namespace {

using Rows = std::vector<std::pair<double, double>>;

/// A number at the start of a text, which is moved behind it.
bool take_number(std::string_view& text, double& value) {
  text.remove_prefix(std::min(text.find_first_not_of(" \t"), text.size()));
  auto const [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc()) return false;
  text.remove_prefix(static_cast<std::size_t>(end - text.data()));
  text.remove_prefix(std::min(text.find_first_not_of(" \t\r"), text.size()));
  return true;
}

/// `time, value` in each line; empty lines and those that begin with # say nothing, and the first may have
/// names.
Rows rows_of_file(SceneTable const& inputs, std::string const& name, std::string const& path,
                  std::string_view text) {
  Rows out;
  for (long line = 1; !text.empty(); ++line) {
    std::size_t const end = std::min(text.find('\n'), text.size());
    std::string_view row = text.substr(0, end);
    text.remove_prefix(std::min(end + 1, text.size()));
    std::string_view const whole = row;
    if (row.find_first_not_of(" \t\r") == row.npos || row.front() == '#') continue;
    double t = 0, value = 0;
    bool const first = take_number(row, t), comma = first && row.starts_with(',');
    if (comma) row.remove_prefix(1);
    if (comma && take_number(row, value) && row.empty()) {
      out.emplace_back(t, value);
    } else if (line > 1 || first) {
      inputs.fail(name, fmt::format("{}: line {} of {}: 'time, value' is expected, found '{}'", name, line,
                                    path, printable(std::string(whole))));
    }
  }
  return out;
}

systems::HeldInput read_input(SceneTable inputs, std::string const& name, SharedNames& shared) {
  Rows rows;
  if (inputs.is_matrix(name)) {
    Eigen::MatrixXd const all = inputs.rows(name, 2);
    for (Eigen::Index k = 0; k < all.rows(); ++k) rows.emplace_back(all(k, 0), all(k, 1));
  } else if (inputs.is_text(name) && inputs.text(name).ends_with(".csv")) {
    auto const [path, text] = inputs.read_file(name, "rows of a time and a value");
    rows = rows_of_file(inputs, name, path, text);
  } else {
    return systems::HeldInput(
        shared.read(inputs.formula(name), {"t"}, inputs.text_place(name), name, for_values).value);
  }
  try {
    return systems::HeldInput(std::move(rows));
  } catch (Error const& error) {
    inputs.fail(name, fmt::format("{}: {}", name, error.what()));
  }
}

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
  std::vector<std::string> given;
  if (force_keys.inputs.given(system)) {
    SceneTable const inputs = system.inside("inputs");
    given = inputs.keys();
    for (auto const& name : given) {
      require_formula_name(inputs, name, names, "a number of the force");
      shared.require_free(inputs, name);
      force.held.push_back(read_input(inputs, name, shared));
    }
  }
  names.insert(names.end(), given.begin(), given.end());
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
  for (auto const& name : given)
    if (!used_here.contains(name))
      system.inside("inputs").fail(name, fmt::format("inputs: '{}' does not occur in the force{}", name,
                                                     meant_used_name(name, used_here)));
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
