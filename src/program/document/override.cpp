// KEY=VALUE of the command line, over what a scene says.
#include <algorithm>
#include <cctype>

#include "program/document/document.hpp"
#include "program/document/file.hpp"

namespace actio::scene {
namespace {

bool is_bare_word(std::string_view word) {
  return !word.empty() && std::isalpha(static_cast<unsigned char>(word.front())) &&
         std::all_of(word.begin(), word.end(),
                     [](unsigned char c) { return std::isalnum(c) || c == '_' || c == '-'; });
}

/// One KEY=VALUE as a table.
toml::table read_override(std::string const& argument, std::string const& name) {
  std::size_t const equals = argument.find('=');
  if (equals == std::string::npos || equals == 0)
    throw SceneError({name, 1, 1}, "KEY=VALUE is expected, for example method.step=0.1");
  if (argument.find('\n') != std::string::npos)
    throw SceneError({name, 1, static_cast<unsigned>(argument.find('\n')) + 1}, "one line is expected");
  std::string_view const value = std::string_view(argument).substr(equals + 1);
  if (is_bare_word(value) && value != "true" && value != "false" && value != "nan" && value != "inf")
    return detail::parse_toml(argument.substr(0, equals) + "=\"" + std::string(value) + "\"", name);
  try {
    return detail::parse_toml(argument, name);
  } catch (SceneError const& error) {
    // What is neither a number nor anything else of TOML was meant as a text.
    char const first = value.empty() ? '\0' : value.front();
    if (value.find_first_of("\"'") != std::string_view::npos || first == '\0' || first == '{') throw;
    throw SceneError(
        error.place,
        std::string(error.what()).substr(printable(error.place.text()).size() + 2) +
            (first == '[' ? "; texts in a list need quotes, for example [\"jacobian\"]"
                          : "; a text that is more than a word needs quotes, for example KEY='\"9.81*y\"'"));
  }
}

/// Moves what is in `from`, with its places, over what is in `into`: a table for each name that leads to the
/// key, and then its value, which takes the place of what was there. So does a table in braces, of which
/// nothing stays whether the scene has it in braces or as a section.
void merge(toml::table& into, toml::table&& from, std::string const& name) {
  for (auto&& [key, node] : from) {
    toml::node* const there = into.get(key.str());
    bool const leads_on = node.is_table() && !node.as_table()->is_inline();
    if (!leads_on || !there)
      into.insert_or_assign(key, std::move(node));
    else if (there->is_table())
      merge(*there->as_table(), std::move(*node.as_table()), name);
    else
      throw SceneError(detail::place_of(key.source(), name),
                       "'" + shown(key.str()) + "' is no table, so nothing in it can be set");
  }
}

/// The names that lead to a key: `method.step`, with quotes and spaces left away.
std::vector<std::string> names_in(std::string_view key) {
  std::vector<std::string> out(1);
  for (char const c : key)
    if (c == '.')
      out.emplace_back();
    else if (c != ' ' && c != '\t' && c != '"' && c != '\'')
      out.back() += c;
  return out;
}

/// What is there of that name; null where there is nothing.
toml::node* find(toml::table& root, std::string_view key) {
  toml::node* node = &root;
  for (auto const& name : names_in(key))
    node = node && node->is_table() ? node->as_table()->get(name) : nullptr;
  return node;
}

/// !KEY
void take_out(toml::table& root, std::string const& key) {
  Place const place{"--unset " + shown(key, 100)};
  if (key.empty() || !find(root, key))
    throw SceneError(place, "the scene has no key '" + shown(key, 100) + "' that could be taken out");
  auto const names = names_in(key);
  toml::table* table = &root;
  for (std::size_t k = 0; k + 1 < names.size(); ++k) table = table->get(names[k])->as_table();
  table->erase(names.back());
}

/// KEY[i]=VALUE, KEY[i][j]=VALUE
void set_item(toml::table& root, std::string const& argument, std::size_t bracket, std::size_t equals,
              std::string const& name) {
  std::string const key = argument.substr(0, bracket);
  toml::node* node = find(root, key);
  if (!node)
    throw SceneError({name, 1, 1}, "the scene has no list '" + shown(key, 100) +
                                       "' of which an item could be set; KEY=[...] sets all of it");
  toml::array* list = nullptr;
  std::size_t item = 0;
  for (std::size_t at = bracket; at < equals;) {
    if (argument[at] == ' ' && ++at) continue;
    unsigned const column = static_cast<unsigned>(at) + 1;
    std::size_t const close = argument.find(']', at);
    std::string const digits =
        argument[at] == '[' && close < equals ? argument.substr(at + 1, close - at - 1) : "";
    if (digits.empty() || digits.size() > 9 || digits.find_first_not_of("0123456789") != std::string::npos)
      throw SceneError(
          {name, 1, column},
          "the number of an item is expected, counted from 0, for example initial.angular_velocity[0]=1");
    node = list ? list->get(item) : node;
    list = node->as_array(), item = std::stoul(digits), at = close + 1;
    if (!list)
      throw SceneError({name, 1, column}, "a list is expected there, found " + detail::described(*node));
    if (item >= list->size())
      throw SceneError({name, 1, column}, "the list has " + std::to_string(list->size()) +
                                              " items, counted from 0; there is no item " + digits);
  }
  // Spaces keep the columns of the argument.
  toml::table value = read_override("x" + std::string(equals - 1, ' ') + argument.substr(equals), name);
  list->replace(list->cbegin() + static_cast<std::ptrdiff_t>(item), std::move(*value.get("x")));
}

}  // namespace

void detail::apply_override(toml::table& root, std::string const& argument) {
  if (argument.starts_with('!')) return take_out(root, argument.substr(1));
  std::string const name = "--set " + shown(argument, 100);
  std::size_t const equals = argument.find('='), bracket = std::min(argument.find('['), argument.size());
  if (equals != std::string::npos && bracket < equals) return set_item(root, argument, bracket, equals, name);
  merge(root, read_override(argument, name), name);
}

std::vector<std::string> split_values(std::string_view list) {
  std::vector<std::string> out(1);
  int depth = 0;
  char quote = 0;
  for (std::size_t i = 0; i < list.size(); ++i) {
    char const c = list[i];
    if (quote) {
      if (c == '\\' && quote == '"' && i + 1 < list.size())
        out.back() += list[i++];
      else if (c == quote)
        quote = 0;
    } else if (c == '"' || c == '\'') {
      quote = c;
    } else if (c == '[' || c == '{' || c == '(') {
      ++depth;
    } else if (c == ']' || c == '}' || c == ')') {
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
