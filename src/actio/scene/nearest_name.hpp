// The name that a mistyped one is nearest to.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace actio::scene {

/// The known name that takes the fewest letters to change, add, drop or swap; empty where none is near (more
/// than a third of the letters, at least two).
std::string nearest_name(std::string_view word, std::vector<std::string> const& known);

/// `; did you mean 'energy'?`, or nothing where no name is near.
std::string did_you_mean(std::string_view word, std::vector<std::string> const& known);

/// `a, b, c`.
std::string listed(std::vector<std::string> const& names);

}  // namespace actio::scene
