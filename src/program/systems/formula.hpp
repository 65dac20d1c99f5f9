// A formula in a scene, with definitions: what is wrong with it is told at its place.
#pragma once

#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "actio/formula/parse_formula.hpp"
#include "program/document/file.hpp"

namespace actio::scene {

/// Formulas with names, and the table of a scene that has them.
struct DefinedFormulas {
  FormulaDefinitions texts = {};         ///< by name
  std::optional<SceneTable> table = {};  ///< none where there are none
};

/// Reads it.
/// @param names      what its inputs are called
/// @param constants  numbers with names
/// @param place      where the text stands
/// @param what       it is called in complaints: "potential"; empty: not at all
/// @param use        whether it is differentiated
/// @param defined    formulas that it may use by their names
/// @throws SceneError  where it is none, and where it defines a name that occurs nowhere else in it
ReadFormula scene_formula(std::string const& text, std::vector<std::string> const& names,
                          std::map<std::string, double> const& constants, TextPlace const& place,
                          std::string const& what = "", FormulaUse use = {},
                          DefinedFormulas const& defined = {});

/// Refuses the name of a key that a formula cannot have, or that stands for something else there.
/// @param taken  names of other numbers, which are so called: "a component"
void require_formula_name(SceneTable const& table, std::string const& key,
                          std::vector<std::string> const& taken, std::string const& what);
/// The numbers of a table within a table, which a formula has by their names; none where it is not there.
/// @throws SceneError  where one has no number, or a name that is refused
std::map<std::string, double> formula_constants(SceneTable const& table, std::string const& key,
                                                std::vector<std::string> const& taken,
                                                std::string const& what);
/// Refuses one of them that the formula does not use.
/// @param formula  what it is called
void require_used_constants(SceneTable const& table, std::string const& key,
                            std::map<std::string, double> const& constants,
                            std::set<std::string, std::less<>> const& used, std::string const& formula);

/// `; did you mean 'c'?`: of the names that are used the one that this name may be meant for.
std::string meant_used_name(std::string const& name, std::set<std::string, std::less<>> const& used);

}  // namespace actio::scene
