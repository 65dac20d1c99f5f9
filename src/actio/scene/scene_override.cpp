// KEY=VALUE of the command line, over what a scene says.
#include <algorithm>
#include <cctype>

#include "actio/scene/scene_document.hpp"
#include "actio/scene/scene_file.hpp"

namespace actio::scene {
namespace {

bool is_bare_word(std::string_view word) {
  return !word.empty() && std::isalpha(static_cast<unsigned char>(word.front())) &&
         std::all_of(word.begin(), word.end(), [](unsigned char c) { return std::isalnum(c) || c == '_' || c == '-'; });
}

/// One KEY=VALUE as a table.
toml::table read_override(std::string const& argument, std::string const& name) {
  std::size_t const equals = argument.find('=');
  if (equals == std::string::npos || equals == 0) throw SceneError({name, 1, 1}, "KEY=VALUE is expected, for example method.step=0.1");
  if (argument.find('\n') != std::string::npos) throw SceneError({name, 1, static_cast<unsigned>(argument.find('\n')) + 1}, "one line is expected");
  std::string_view const value = std::string_view(argument).substr(equals + 1);
  if (is_bare_word(value) && value != "true" && value != "false" && value != "nan" && value != "inf")
    return detail::parse_toml(argument.substr(0, equals) + "=\"" + std::string(value) + "\"", name);
  return detail::parse_toml(argument, name);
}

/// Moves what is in `from`, with its places, over what is in `into`.
void merge(toml::table& into, toml::table&& from, std::string const& name) {
  for (auto&& [key, node] : from) {
    toml::node* const there = into.get(key.str());
    // A table in braces that takes the place of another one is a value like any: nothing of the other stays.
    bool const values = node.is_table() && there && there->is_table() && node.as_table()->is_inline() &&
                        there->as_table()->is_inline();
    if (values)
      into.insert_or_assign(key, std::move(node));
    else if (node.is_table() && there && there->is_table())
      merge(*there->as_table(), std::move(*node.as_table()), name);
    else if (node.is_table() && there)
      throw SceneError(detail::place_of(key.source(), name), "'" + shown(key.str()) + "' is no table, so nothing in it can be set");
    else
      into.insert_or_assign(key, std::move(node));
  }
}

}  // namespace

void detail::apply_override(toml::table& root, std::string const& argument) {
  std::string const name = "--set " + shown(argument, 100);
  merge(root, read_override(argument, name), name);
}

std::vector<std::string> split_values(std::string_view list) {
  std::vector<std::string> out(1);
  int depth = 0;
  char quote = 0;
  for (std::size_t i = 0; i < list.size(); ++i) {
    char const c = list[i];
    if (quote) {
      if (c == '\\' && quote == '"' && i + 1 < list.size()) out.back() += list[i++];
      else if (c == quote) quote = 0;
    } else if (c == '"' || c == '\'') {
      quote = c;
    } else if (c == '[' || c == '{') {
      ++depth;
    } else if (c == ']' || c == '}') {
      --depth;
    } else if (c == ',' && depth == 0) {
      out.emplace_back();
      continue;
    }
    out.back() += list[i];
  }
  return out;
}

}  // namespace actio::scene
