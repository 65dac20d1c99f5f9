// The TOML behind a scene. For the reader's own files: what includes them else needs no TOML.
#pragma once

#include <toml++/toml.h>

#include <string>
#include <string_view>
#include <vector>

#include "program/base/error.hpp"
#include "program/document/input_files.hpp"

namespace actio::scene::detail {

/// What a scene was read into, and what was written back since.
struct SceneDocument {
  using Path = std::vector<std::string>;

  std::string name;
  toml::table root;
  unsigned last_line = 1;
  std::vector<Path> defaults;  ///< what was written back, in that order
  InputFiles inputs;           ///< files that it names, and that were read

  /// The table at a path; null where there is none.
  /// @throws SceneError  where something on the way is no table, at its place
  toml::table* table(Path const& path);
  /// The value of a key of a table; null where there is none.
  toml::node const* value(Path const& path, std::string const& key);
  /// Writes a default.
  template <class Value>
  void set(Path path, std::string const& key, Value&& value) {
    made(path).insert_or_assign(key, std::forward<Value>(value));
    path.push_back(key);
    defaults.push_back(std::move(path));
  }

 private:
  toml::table& made(Path const& path);
};

/// Where something stands; `otherwise` names the file of what stands nowhere.
Place place_of(toml::source_region const& region, std::string const& otherwise);
/// What a value is, for a complaint: `'fast' (a text)`.
std::string described(toml::node const& node);

/// Refuses a word that is none of those that are allowed, with the nearest of them.
/// @param what  it is called
/// @param see   where the allowed ones are listed; empty: all of them are told
/// @throws SceneError  at this place
[[noreturn]] void fail_unknown(Place const& place, std::string const& what, std::string const& word,
                               std::vector<std::string> const& allowed, std::string const& see);

/// The largest text of a scene: 200 000 numbers with all their digits, read in less than a second.
inline constexpr std::size_t largest_text = 4 << 20;

/// Reads TOML. Its size and the depth of its names are bounded, so that reading takes little time and little
/// of the stack.
/// @throws SceneError  with the place of what is no TOML
toml::table parse_toml(std::string_view text, std::string const& name);

/// Sets what one KEY=VALUE says.
/// @throws SceneError  with the place in the argument
void apply_override(toml::table& root, std::string const& argument);

}  // namespace actio::scene::detail
