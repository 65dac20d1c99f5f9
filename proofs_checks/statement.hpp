// STATEMENT(id, title) { ... }: the check of one statement of the thesis.
//
// The body is a function of `claim` (claim.hpp) and `draw` (random points, draw.hpp) over the scalar S, whose
// arithmetic is chosen when the program runs: it is compiled once. It visits each of its models at one random
// point; the program calls it as often as the column asks for points. `exact_arithmetic<S>()` tells where
// there are no roots, `ordered_arithmetic<S>()` where numbers have sizes.
//
// A source runs in all columns unless a line of its head names those that it is meant for: COLUMNS("prime
// rational double").
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "claim.hpp"

namespace actio::checks {

/// A check that has been compiled into this program.
struct Check {
  char const *id, *title, *source;
  void (*body)(Claim<Number>&, Draw&);
};
/// All checks of this program, in the order of their registration.
std::vector<Check>& all_checks();    // run.cpp
bool add_check(Check const& check);  // run.cpp

/// The columns there are: prime, rational, double, 50, 100, ball.
std::vector<std::string> const& all_columns();  // run.cpp
/// The columns that a source is meant for: all but ball where it names none.
std::vector<std::string> columns_of(std::string const& source);  // run.cpp
/// @param columns  names of columns, separated by blanks
bool set_columns(char const* source, char const* columns);  // run.cpp

}  // namespace actio::checks

#define STATEMENT(id, title)                                                                                \
  template <class S>                                                                                        \
  static void id(actio::checks::Claim<S>& claim, actio::Draw& draw);                                        \
  static bool const registered_##id = actio::checks::add_check({#id, title, __FILE__, &id<actio::Number>}); \
  template <class S>                                                                                        \
  static void id([[maybe_unused]] actio::checks::Claim<S>& claim, [[maybe_unused]] actio::Draw& draw)

#define COLUMNS(names) static bool const columns_are_set = actio::checks::set_columns(__FILE__, names)
