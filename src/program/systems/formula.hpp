// A formula in a scene, with definitions: what is wrong with it is told at its place.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "actio/formula/parse_formula.hpp"
#include "program/base/error.hpp"

namespace actio::scene {

/// Reads it.
/// @param names      what its inputs are called
/// @param constants  numbers with names
/// @param place      where the text stands
/// @param what       it is called in complaints: "potential"; empty: not at all
/// @param use        whether it is differentiated
/// @throws SceneError  where it is none, and where it defines a name that occurs nowhere else in it
ReadFormula scene_formula(std::string const& text, std::vector<std::string> const& names,
                          std::map<std::string, double> const& constants, TextPlace const& place,
                          std::string const& what = "", FormulaUse use = {});

/// `; did you mean 'c'?`: of the names that are used the one that this name may be meant for.
std::string meant_used_name(std::string const& name, std::set<std::string, std::less<>> const& used);

}  // namespace actio::scene
