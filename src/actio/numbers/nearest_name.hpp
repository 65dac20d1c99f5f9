// The name that a mistyped one is nearest to.
#pragma once

#include <algorithm>
#include <string>
#include <string_view>
#include <vector>

namespace actio {

namespace detail {
/// Letters to change, add, drop or swap with their neighbour (Damerau's distance without repeated edits).
std::size_t letters_apart(std::string_view a, std::string_view b);
}  // namespace detail

/// The known name that takes the fewest letters to change, add, drop or swap; empty where none is near (more
/// than a third of the letters, at least two).
std::string nearest_name(std::string_view word, std::vector<std::string> const& known);

/// `; did you mean 'energy'?`, or nothing where no name is near.
inline std::string did_you_mean(std::string_view word, std::vector<std::string> const& known) {
  std::string const name = nearest_name(word, known);
  return name.empty() ? "" : "; did you mean '" + name + "'?";
}

/// `a, b, c`.
inline std::string listed(std::vector<std::string> const& names) {
  std::string out;
  for (auto const& name : names) out += (out.empty() ? "" : ", ") + name;
  return out;
}

}  // namespace actio
