// A scene, written back: what is read from it again is what was read and what was filled in, to the last bit.
#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <sstream>
#include <tuple>

#include "program/document/document.hpp"
#include "program/document/file.hpp"

namespace actio::scene {
namespace {

using detail::SceneDocument;

std::string in_quotes(std::string_view text) {
  std::string out = "\"";
  for (unsigned char const c : text) {
    if (c == '"' || c == '\\')
      out += '\\', out += static_cast<char>(c);
    else if (c == '\n')
      out += "\\n";
    else if (c == '\t')
      out += "\\t";
    else if (c < 0x20 || c == 0x7f)
      out += fmt::format("\\u{:04x}", c);
    else
      out += static_cast<char>(c);
  }
  return out + '"';
}

std::string key_in_toml(std::string_view key) {
  bool const bare = !key.empty() && std::all_of(key.begin(), key.end(), [](unsigned char c) {
    return (c < 128 && std::isalnum(c)) || c == '_' || c == '-';
  });
  return bare ? std::string(key) : in_quotes(key);
}

std::string in_toml(double x) {
  if (!std::isfinite(x)) return std::isnan(x) ? "nan" : x > 0 ? "inf" : "-inf";
  char digits[32];
  std::string text(digits, std::to_chars(digits, digits + sizeof digits, x).ptr);
  if (text.find_first_of(".e") == std::string::npos) text += ".0";
  return text;
}

template <class Date>
std::string date_in_toml(Date const& date) {
  std::ostringstream out;
  out << date;
  return out.str();
}

std::string in_toml(toml::node const& node) {
  if (auto const* text = node.as_string()) return in_quotes(text->get());
  if (auto const* number = node.as_floating_point()) return in_toml(number->get());
  if (auto const* number = node.as_integer()) return fmt::format("{}", number->get());
  if (auto const* truth = node.as_boolean()) return truth->get() ? "true" : "false";
  if (auto const* date = node.as_date()) return date_in_toml(date->get());
  if (auto const* time = node.as_time()) return date_in_toml(time->get());
  if (auto const* instant = node.as_date_time()) return date_in_toml(instant->get());
  std::string out;
  auto const add = [&](std::string const& item) { out += (out.empty() ? "" : ", ") + item; };
  if (auto const* table = node.as_table()) {
    for (auto const& [key, value] : *table) add(key_in_toml(key.str()) + " = " + in_toml(value));
    return out.empty() ? "{}" : "{ " + out + " }";
  }
  for (auto const& item : *node.as_array()) add(in_toml(item));
  return "[" + out + "]";
}

/// The keys of a table as they are told: those of the file in its order, then overrides, then defaults in the
/// order of writing.
struct Entry {
  std::size_t rank;
  unsigned line, column;
  std::string key;
  toml::node const* node;
};

std::vector<Entry> entries_of(SceneDocument const& document, toml::table const& table,
                              SceneDocument::Path const& path) {
  std::vector<Entry> entries;
  for (auto const& [key, node] : table) {
    SceneDocument::Path whole = path;
    whole.emplace_back(key.str());
    auto const written = std::find(document.defaults.begin(), document.defaults.end(), whole);
    auto const begin = node.source().begin;
    bool const of_file = node.source().path && *node.source().path == document.name;
    std::size_t const rank = written != document.defaults.end()
                                 ? 2 + static_cast<std::size_t>(written - document.defaults.begin())
                             : of_file ? 0
                                       : 1;
    entries.push_back({rank, begin.line, begin.column, whole.back(), &node});
  }
  std::sort(entries.begin(), entries.end(), [](Entry const& a, Entry const& b) {
    return std::tie(a.rank, a.line, a.column, a.key) < std::tie(b.rank, b.line, b.column, b.key);
  });
  return entries;
}

/// Whether it has a header of its own: what was written in braces stays there.
bool has_header(toml::node const& node) { return node.is_table() && !node.as_table()->is_inline(); }

void write_values(std::vector<Entry> const& entries, std::string& out) {
  for (auto const& entry : entries)
    if (!has_header(*entry.node)) out += key_in_toml(entry.key) + " = " + in_toml(*entry.node) + "\n";
}

/// A table and those in it.
void write_table(SceneDocument const& document, toml::table const& table, SceneDocument::Path const& path,
                 std::string& out) {
  std::string header;
  for (auto const& key : path) header += (header.empty() ? "" : ".") + key_in_toml(key);
  out += (out.empty() ? "[" : "\n[") + header + "]\n";
  auto const entries = entries_of(document, table, path);
  write_values(entries, out);
  for (auto const& entry : entries)
    if (auto const* inner = has_header(*entry.node) ? entry.node->as_table() : nullptr) {
      SceneDocument::Path deeper = path;
      deeper.push_back(entry.key);
      write_table(document, *inner, deeper, out);
    }
}

}  // namespace

std::string SceneFile::written() const {
  std::string out;
  auto values = entries_of(*document_, document_->root, {});
  std::erase_if(values, [](Entry const& entry) { return entry.node->is_table(); });
  write_values(values, out);
  std::vector<std::string> order{"scene", "system", "initial", "method", "run", "output"};
  for (auto const& [key, node] : document_->root)
    if (std::find(order.begin(), order.end(), key.str()) == order.end()) order.emplace_back(key.str());
  for (auto const& name : order)
    if (auto const* node = document_->root.get(name); node && node->is_table())
      write_table(*document_, *node->as_table(), {name}, out);
  return out;
}

}  // namespace actio::scene
