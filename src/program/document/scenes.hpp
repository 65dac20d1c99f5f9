// The scenes that the program carries with it, data/scenes: `actio run apophis` runs one, `actio new apophis`
// writes it.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace actio::scene {

/// A scene that the program carries.
struct NamedScene {
  std::string name,       ///< of its file, without the ending
      title,              ///< for people
      system;             ///< the name of its kind of system
  std::string_view text;  ///< in TOML, with its comments
};

/// All of them, in the order of their names.
std::vector<NamedScene> const& carried_scenes();
/// The one of that name; null where there is none.
NamedScene const* find_scene(std::string const& name);

}  // namespace actio::scene
