#include "program/systems/shared_names.hpp"

#include <fmt/format.h>

namespace actio::scene {

SharedNames::SharedNames(SceneTable table, std::vector<std::string> const& components,
                         std::vector<std::string> const& of_force)
    : table_(std::move(table)),
      parameters_(formula_constants(table_, "parameters", components, "a component")) {
  if (!table_.has("definitions")) return;
  SceneTable const within = table_.inside("definitions");
  definitions_.table = within;
  for (auto const& name : within.keys()) {
    require_formula_name(within, name, components, "a component");
    require_formula_name(within, name, of_force, "a number of the force");
    if (parameters_.contains(name)) require_free(within, name);
    definitions_.texts.emplace(name, within.formula(name));
  }
}

ReadFormula SharedNames::read(std::string const& text, std::vector<std::string> const& names,
                              TextPlace const& place, std::string const& what, FormulaUse use) {
  auto formula = scene_formula(text, names, parameters_, place, what, use, definitions_);
  used_.insert(formula.used.begin(), formula.used.end());
  return formula;
}

void SharedNames::require_free(SceneTable const& table, std::string const& key) const {
  bool const parameter = parameters_.contains(key);
  if (parameter || definitions_.texts.contains(key))
    table.fail(key, fmt::format("the name '{}' is taken already: it is a {}", key,
                                parameter ? "parameter" : "definition"));
}

void SharedNames::require_used(std::string const& formulas) const {
  require_used_constants(table_, "parameters", parameters_, used_, formulas);
  for (auto const& [name, text] : definitions_.texts)
    if (!used_.contains(name))
      definitions_.table->fail(name, fmt::format("definitions: '{}' does not occur in the {}{}", name,
                                                 formulas, meant_used_name(name, used_)));
}

}  // namespace actio::scene
