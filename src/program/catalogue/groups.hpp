// The groups of the library, as `actio list groups` and `actio show` tell them.
#pragma once

#include <optional>
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

/// A group with its numbers, as a scene names it, and what a formula can say of its velocity.
struct NamedGroup {
  std::string name;                     ///< `SO(3) x R^1`
  std::vector<std::string> components;  ///< of the velocity, in their order
  /// rows of its matrix, `[0, -w, v1]`; empty where there are more than 6
  std::vector<std::string> velocity;
};

/// All of them.
std::vector<LibraryGroup> const& library_groups();
/// Those that a word names, however it is written: `SO(3)`, `so3` and `so` are SO(n); `SE` is SE(2) and
/// SE(3).
std::vector<LibraryGroup const*> find_groups(std::string_view word);

/// The group that a word names with its numbers, however it is written: `SO(3)`, `so3`, `SO(3) x R^1`; none
/// where it names none, or a family, or one that is too large for a scene.
std::optional<NamedGroup> named_group(std::string_view word);
/// The names of the components of the velocity on a group or a family, in their order: `w v1 v2`.
std::string components_of(LibraryGroup const& group);

}  // namespace actio::scene
