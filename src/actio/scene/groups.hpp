// The groups of the library, as `actio list groups` and `actio show` tell them.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace actio::scene {

/// A group, or a family of groups, that the library computes with.
struct LibraryGroup {
  std::string name;         ///< `SO(n)`
  std::string dimension;    ///< `n (n - 1) / 2`
  std::string meaning;      ///< one sentence
  std::string coordinates;  ///< of its algebra
  std::string type;         ///< `actio::SO<n>`
  std::string header;       ///< to include
  std::string statement;    ///< of the thesis: where it stands, or what every group here brings
};

/// All of them.
std::vector<LibraryGroup> const& library_groups();
/// Those that a word names, however it is written: `SO(3)`, `so3` and `so` are SO(n); `SE` is SE(2) and
/// SE(3).
std::vector<LibraryGroup const*> find_groups(std::string_view word);

}  // namespace actio::scene
