#include "program/systems/formula.hpp"

namespace actio::scene {

ReadFormula scene_formula(std::string const& text, std::vector<std::string> const& names,
                          std::map<std::string, double> const& constants, TextPlace const& place,
                          std::string const& what, FormulaUse use) {
  std::string const begin = what.empty() ? "" : what + ": ";
  try {
    ReadFormula formula = read_formula(text, names, constants, use);
    for (auto const& [name, position] : formula.unused)
      throw FormulaError(position, "'" + shown(name) + "' is defined, and nothing in the formula uses it" +
                                       meant_used_name(name, formula.used));
    return formula;
  } catch (FormulaError const& error) {
    place.fail(text, error.position, begin + error.what());
  } catch (Error const& error) {
    place.fail(text, 0, begin + error.what());
  }
}

std::string meant_used_name(std::string const& name, std::set<std::string, std::less<>> const& used) {
  return actio::detail::meant_name(name, {used.begin(), used.end()});
}

}  // namespace actio::scene
