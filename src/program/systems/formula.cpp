#include "program/systems/formula.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "actio/formula/formula_names.hpp"
#include "actio/formula/formula_text.hpp"

namespace actio::scene {

ReadFormula scene_formula(std::string const& text, std::vector<std::string> const& names,
                          std::map<std::string, double> const& constants, TextPlace const& place,
                          std::string const& what, FormulaUse use, DefinedFormulas const& defined) {
  std::string const begin = what.empty() ? "" : what + ": ";
  try {
    ReadFormula formula = read_formula(text, names, constants, use, defined.texts);
    for (auto const& [name, position] : formula.unused)
      throw FormulaError(position, "'" + shown(name) + "' is defined, and nothing in the formula uses it" +
                                       meant_used_name(name, formula.used));
    return formula;
  } catch (FormulaError const& error) {
    if (auto const& name = error.within; !name.empty())
      defined.table->text_place(name).fail(defined.texts.at(name), error.position,
                                           name + ": " + error.what());
    place.fail(text, error.position, begin + error.what());
  } catch (Error const& error) {
    place.fail(text, 0, begin + error.what());
  }
}

void require_formula_name(SceneTable const& table, std::string const& key,
                          std::vector<std::string> const& taken, std::string const& what) {
  if (!actio::detail::is_name(key))
    table.fail(key,
               fmt::format("'{}' is no name for a formula: letters, digits and _ are, a letter or _ first",
                           printable(key)));
  if (std::ranges::find(taken, key) != taken.end())
    table.fail(key, fmt::format("the name '{}' is taken already: it is {}", key, what));
  if (actio::detail::has_a_meaning(key))
    table.fail(key, fmt::format("the name '{}' is taken already: formulas know it", key));
}

std::map<std::string, double> formula_constants(SceneTable const& table, std::string const& key,
                                                std::vector<std::string> const& taken,
                                                std::string const& what) {
  std::map<std::string, double> out;
  if (!table.has(key)) return out;
  SceneTable const within = table.inside(key);
  for (auto const& name : within.keys()) {
    require_formula_name(within, name, taken, what);
    out[name] = within.number(name);
  }
  return out;
}

void require_used_constants(SceneTable const& table, std::string const& key,
                            std::map<std::string, double> const& constants,
                            std::set<std::string, std::less<>> const& used, std::string const& formula) {
  for (auto const& [name, value] : constants)
    if (!used.contains(name))
      table.inside(key).fail(name, fmt::format("{}: '{}' does not occur in the {}{}", key, name, formula,
                                               meant_used_name(name, used)));
}

std::string meant_used_name(std::string const& name, std::set<std::string, std::less<>> const& used) {
  return actio::detail::meant_name(name, {used.begin(), used.end()});
}

}  // namespace actio::scene
