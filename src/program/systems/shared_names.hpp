// What several formulas of a scene have by name: numbers of `parameters` and formulas of `definitions`.
#pragma once

#include <map>
#include <set>
#include <string>
#include <vector>

#include "program/systems/formula.hpp"

namespace actio::scene {

/// The numbers and the formulas with names that formulas of one table share, and which of them they use.
///
/// Definitions are read where they are used: one for a force may have kinks, and names that only the force
/// knows.
class SharedNames {
 public:
  using Names = std::set<std::string, std::less<>>;  ///< in the order of letters

  /// @param table       that has `parameters` and `definitions`, if any
  /// @param components  names that the formulas have beside them, which are so called in complaints
  /// @param of_force    further names that only a force has, and no definition
  /// @throws SceneError  where a name is none for a formula or is taken, and where a parameter is no number
  SharedNames(SceneTable table, std::vector<std::string> const& components,
              std::vector<std::string> const& of_force);

  /// Reads a formula as `scene_formula` does. What is wrong in a definition is told at its place.
  ReadFormula read(std::string const& text, std::vector<std::string> const& names, TextPlace const& place,
                   std::string const& what = "", FormulaUse use = {});
  /// The names that occur in the formulas so far.
  Names const& used() const { return used_; }
  /// Whether there is a parameter of this name.
  bool has_parameter(std::string const& name) const { return parameters_.contains(name); }
  /// Refuses a key of another table that has the name of a parameter or of a definition.
  void require_free(SceneTable const& table, std::string const& key) const;
  /// Refuses a parameter and a definition that no formula uses.
  /// @param formulas  what they are called together
  void require_used(std::string const& formulas) const;

 private:
  SceneTable table_;
  std::map<std::string, double> parameters_;
  DefinedFormulas definitions_;
  Names used_;
};

}  // namespace actio::scene
