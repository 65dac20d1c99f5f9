#include "program/document/document.hpp"

#include <fmt/format.h>

#include "actio/numbers/nearest_name.hpp"

namespace actio::scene::detail {
namespace {

/// The table that a node is.
/// @throws SceneError  where it is something else, at its place
toml::table* as_table(toml::node& node, std::string const& key, std::string const& file) {
  if (toml::table* const table = node.as_table()) return table;
  throw SceneError(place_of(node.source(), file),
                   fmt::format("{}: a table is expected, found {}", shown(key), described(node)));
}

}  // namespace

toml::table* SceneDocument::table(Path const& path) {
  toml::table* table = &root;
  for (auto const& key : path) {
    toml::node* const node = table->get(key);
    if (!node) return nullptr;
    table = as_table(*node, key, name);
  }
  return table;
}
toml::node const* SceneDocument::value(Path const& path, std::string const& key) {
  toml::table const* const found = table(path);
  return found ? found->get(key) : nullptr;
}
toml::table& SceneDocument::made(Path const& path) {
  toml::table* table = &root;
  for (auto const& key : path) {
    if (!table->get(key)) table->insert(key, toml::table{});
    table = as_table(*table->get(key), key, name);
  }
  return *table;
}

Place place_of(toml::source_region const& region, std::string const& otherwise) {
  if (!region.begin) return {otherwise};
  return {region.path ? *region.path : otherwise, region.begin.line, region.begin.column};
}

std::string described(toml::node const& node) {
  if (auto const* text = node.as_string()) return "'" + shown(text->get(), 40) + "' (a text)";
  if (auto const* number = node.as_floating_point()) {
    std::string text = fmt::format("{}", number->get());
    // 2.0 is told as it is written: that it is no whole number is what is wrong with it.
    if (text.find_first_not_of("-0123456789") == std::string::npos) text += ".0";
    return text;
  }
  if (auto const* number = node.as_integer()) return fmt::format("{}", number->get());
  if (auto const* truth = node.as_boolean()) return truth->get() ? "true" : "false";
  if (auto const* list = node.as_array()) return fmt::format("a list of {}", list->size());
  if (node.is_table()) return "a table";
  return "a date or a time";
}

void fail_unknown(Place const& place, std::string const& what, std::string const& word,
                  std::vector<std::string> const& allowed, std::string const& see) {
  throw SceneError(place,
                   fmt::format("unknown {} '{}'{} ({})", what, shown(word), did_you_mean(word, allowed),
                               see.empty() ? "known: " + listed(allowed) : see));
}

}  // namespace actio::scene::detail
