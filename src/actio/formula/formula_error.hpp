// What is wrong with the text of a formula, and where.
#pragma once

#include <cstddef>
#include <string>

#include "actio/numbers/errors.hpp"

namespace actio {

/// A text that is no formula: what was found, what is expected and, for a name, the nearest known one.
struct FormulaError : Error {
  /// the byte of the text where it goes wrong, from 0; its length where it ends too soon
  std::size_t position;
  std::string within = {};  ///< the named formula whose text that is; empty: the text that was given
  /// @param at             the byte of the text
  /// @param what_is_wrong  one line
  FormulaError(std::size_t at, std::string const& what_is_wrong) : Error(what_is_wrong), position(at) {}
};

}  // namespace actio
