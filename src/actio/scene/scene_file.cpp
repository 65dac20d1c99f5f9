#include "actio/scene/scene_file.hpp"

#include <fmt/format.h>
#include <toml++/toml.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <set>

#include "actio/scene/nearest_name.hpp"

namespace actio::scene {

struct detail::SceneDocument {
  std::string name;
  toml::table root;
  unsigned last_line = 1;
  std::vector<std::vector<std::string>> defaults;  // paths of what was written back, in that order

  /// The table at a path; null where there is none.
  toml::table* find(std::vector<std::string> const& path) {
    toml::table* table = &root;
    for (auto const& key : path) {
      toml::node* const node = table->get(key);
      table = node ? node->as_table() : nullptr;
      if (!table) return nullptr;
    }
    return table;
  }
  /// The same, made where there is none.
  toml::table& make(std::vector<std::string> const& path) {
    toml::table* table = &root;
    for (auto const& key : path) {
      if (!table->get(key)) table->insert(key, toml::table{});
      table = table->get(key)->as_table();
    }
    return *table;
  }
};

namespace {

constexpr std::size_t largest_file = 16 << 20;

Place place_of(toml::source_region const& region, std::string const& otherwise) {
  if (!region.begin) return {otherwise};
  return {region.path ? *region.path : otherwise, region.begin.line, region.begin.column};
}

/// What a value is, for a complaint: `'fast' (a text)`.
std::string described(toml::node const& node) {
  if (auto const* text = node.as_string()) {
    std::string shown = text->get().substr(0, 40);
    for (char& c : shown)
      if (static_cast<unsigned char>(c) < 32) c = ' ';
    return "'" + shown + (text->get().size() > 40 ? "...' (a text)" : "' (a text)");
  }
  if (auto const* number = node.as_floating_point()) return fmt::format("{}", number->get());
  if (auto const* number = node.as_integer()) return fmt::format("{}", number->get());
  if (auto const* truth = node.as_boolean()) return truth->get() ? "true" : "false";
  if (auto const* list = node.as_array()) return fmt::format("a list of {}", list->size());
  if (node.is_table()) return "a table";
  return "a date or a time";
}

SceneError parse_failure(toml::parse_error const& error, std::string const& name) {
  return {place_of(error.source(), name), std::string(error.description())};
}

bool is_bare_word(std::string_view word) {
  return !word.empty() && std::isalpha(static_cast<unsigned char>(word.front())) &&
         std::all_of(word.begin(), word.end(), [](unsigned char c) { return std::isalnum(c) || c == '_' || c == '-'; });
}

/// One KEY=VALUE as a table.
toml::table read_override(std::string const& argument) {
  std::string const name = "--set " + argument;
  std::size_t const equals = argument.find('=');
  if (equals == std::string::npos || equals == 0) throw SceneError({name, 1, 1}, "KEY=VALUE is expected, for example method.step=0.1");
  std::string_view value = std::string_view(argument).substr(equals + 1);
  if (value.find('\n') != std::string_view::npos || argument.find('\n') < equals) throw SceneError({name, 1, 1}, "one line is expected");
  if (is_bare_word(value) && value != "true" && value != "false" && value != "nan" && value != "inf")
    return toml::parse(argument.substr(0, equals) + "=\"" + std::string(value) + "\"", name);
  return toml::parse(argument, name);
}

void merge(toml::table& into, toml::table const& from, std::string const& name) {
  for (auto const& [key, node] : from) {
    toml::node* const there = into.get(key.str());
    if (node.is_table() && there && there->is_table())
      merge(*there->as_table(), *node.as_table(), name);
    else if (node.is_table() && there)
      throw SceneError(place_of(key.source(), name), "'" + std::string(key.str()) + "' is no table, so nothing in it can be set");
    else
      into.insert_or_assign(key, node);
  }
}

toml::table parse_toml(std::string_view text, std::string const& name) {
  try {
    return toml::parse(text, name);
  } catch (toml::parse_error const& error) {
    throw parse_failure(error, name);
  }
}

/// The value of a key.
toml::node const& value_of(detail::SceneDocument& document, std::vector<std::string> const& path, SceneTable const& table, std::string const& key) {
  toml::table const* const found = document.find(path);
  toml::node const* const node = found ? found->get(key) : nullptr;
  if (!node) throw SceneError(table.place(), "[" + table.name() + "] needs '" + key + "'");
  return *node;
}

double finite_number(toml::node const& node, Place const& place, std::string const& key) {
  if (!node.is_number()) throw SceneError(place, fmt::format("{}: a number is expected, found {}", key, described(node)));
  double const value = *node.value<double>();
  if (!std::isfinite(value)) throw SceneError(place, fmt::format("{}: a finite number is expected, found {}", key, described(node)));
  return value;
}

// ---- TOML, written

std::string quoted(std::string const& text) {
  std::string out = "\"";
  for (unsigned char const c : text) {
    if (c == '"' || c == '\\')
      out += '\\', out += static_cast<char>(c);
    else if (c < 0x20 || c == 0x7f)
      out += fmt::format("\\u{:04x}", c);
    else
      out += static_cast<char>(c);
  }
  return out + '"';
}

std::string in_toml(double x) {
  char digits[32];
  std::string text(digits, std::to_chars(digits, digits + sizeof digits, x).ptr);
  if (text.find_first_of(".e") == std::string::npos) text += ".0";
  return text;
}

std::string in_toml(toml::node const& node) {
  if (auto const* text = node.as_string()) return quoted(text->get());
  if (auto const* number = node.as_floating_point()) return in_toml(number->get());
  if (auto const* number = node.as_integer()) return fmt::format("{}", number->get());
  if (auto const* truth = node.as_boolean()) return truth->get() ? "true" : "false";
  std::string out;
  if (auto const* list = node.as_array()) {
    for (auto const& item : *list) out += (out.empty() ? "" : ", ") + in_toml(item);
    return "[" + out + "]";
  }
  return out;  // tables have sections of their own; dates no scene takes
}

std::string key_in_toml(std::string_view key) {
  bool const bare = !key.empty() && std::all_of(key.begin(), key.end(), [](unsigned char c) { return (c < 128 && std::isalnum(c)) || c == '_' || c == '-'; });
  return bare ? std::string(key) : quoted(std::string(key));
}

}  // namespace

// ---- SceneTable

std::string SceneTable::name() const {
  std::string out;
  for (auto const& key : path_) out += (out.empty() ? "" : ".") + key;
  return out;
}

void SceneTable::allow(std::vector<std::string> const& keys) const {
  toml::table const* const table = document_->find(path_);
  if (!table) return;
  // The first in the file, not in the alphabet.
  toml::key const* first = nullptr;
  for (auto const& [key, node] : *table) {
    if (std::find(keys.begin(), keys.end(), key.str()) != keys.end()) continue;
    if (!first || std::pair(key.source().begin.line, key.source().begin.column) < std::pair(first->source().begin.line, first->source().begin.column)) first = &key;
  }
  if (!first) return;
  std::string const where = path_.empty() ? "section" : "key", word(first->str());
  throw SceneError(place_of(first->source(), document_->name), fmt::format("unknown {} '{}'{}{} ({})", where, word, path_.empty() ? "" : " in [" + name() + "]", did_you_mean(word, keys),
                                                                         (keys.empty() ? std::string("none is known here") : "known: " + listed(keys))));
}

bool SceneTable::has(std::string const& key) const {
  toml::table const* const table = document_->find(path_);
  return table && table->get(key);
}

Place SceneTable::place() const {
  toml::table const* const table = document_->find(path_);
  if (table && table->source().begin) return place_of(table->source(), document_->name);
  return {document_->name, document_->last_line, 1};
}
Place SceneTable::place(std::string const& key) const {
  toml::table const* const table = document_->find(path_);
  toml::node const* const node = table ? table->get(key) : nullptr;
  return node && node->source().begin ? place_of(node->source(), document_->name) : place();
}
Place SceneTable::place(std::string const& key, std::size_t item) const {
  toml::table const* const table = document_->find(path_);
  toml::node const* const node = table ? table->get(key) : nullptr;
  toml::array const* const list = node ? node->as_array() : nullptr;
  return list && item < list->size() ? place_of(list->get(item)->source(), document_->name) : place(key);
}
void SceneTable::fail(std::string const& key, std::string const& what) const { throw SceneError(place(key), what); }

double SceneTable::number(std::string const& key) const { return finite_number(value_of(*document_, path_, *this, key), place(key), key); }
double SceneTable::positive(std::string const& key) const {
  double const value = number(key);
  if (!(value > 0)) fail(key, fmt::format("{}: a number > 0 is expected, found {}", key, value));
  return value;
}
long SceneTable::integer(std::string const& key, long least, long most) const {
  auto const& node = value_of(*document_, path_, *this, key);
  auto const* const value = node.as_integer();
  if (!value) fail(key, fmt::format("{}: a whole number is expected, found {}", key, described(node)));
  if (value->get() < least || value->get() > most) fail(key, fmt::format("{}: a whole number from {} to {} is expected, found {}", key, least, most, value->get()));
  return static_cast<long>(value->get());
}
bool SceneTable::boolean(std::string const& key) const {
  auto const& node = value_of(*document_, path_, *this, key);
  if (!node.is_boolean()) fail(key, fmt::format("{}: true or false is expected, found {}", key, described(node)));
  return *node.value<bool>();
}
std::string SceneTable::text(std::string const& key) const {
  auto const& node = value_of(*document_, path_, *this, key);
  if (!node.is_string()) fail(key, fmt::format("{}: a text is expected, found {}", key, described(node)));
  return *node.value<std::string>();
}
std::string SceneTable::choice(std::string const& key, std::string const& what, std::vector<std::string> const& allowed, std::string const& see) const {
  std::string const word = text(key);
  if (std::find(allowed.begin(), allowed.end(), word) == allowed.end())
    fail(key, fmt::format("unknown {} '{}'{} ({})", what, word, did_you_mean(word, allowed), see.empty() ? "known: " + listed(allowed) : see));
  return word;
}

namespace {

toml::array const& list_of(toml::node const& node, Place const& place, std::string const& key, std::string const& expected) {
  auto const* const list = node.as_array();
  if (!list) throw SceneError(place, fmt::format("{}: {} is expected, found {}", key, expected, described(node)));
  return *list;
}

std::vector<double> numbers_in(toml::array const& list, Place const& place, std::string const& key, long size, std::string const& file) {
  if (size >= 0 && list.size() != static_cast<std::size_t>(size)) throw SceneError(place, fmt::format("{}: {} numbers are expected, found {}", key, size, list.size()));
  std::vector<double> values;
  for (auto const& item : list) values.push_back(finite_number(item, place_of(item.source(), file), key));
  return values;
}

}  // namespace

std::vector<std::string> SceneTable::choices(std::string const& key, std::string const& what, std::vector<std::string> const& allowed, std::string const& see) const {
  auto const& list = list_of(value_of(*document_, path_, *this, key), place(key), key, "a list of texts");
  if (list.empty()) fail(key, fmt::format("{}: at least one {} is expected ({})", key, what, see.empty() ? "known: " + listed(allowed) : see));
  std::vector<std::string> words;
  for (std::size_t i = 0; i < list.size(); ++i) {
    auto const* const text = list.get(i)->as_string();
    if (!text) throw SceneError(place(key, i), fmt::format("{}: a text is expected, found {}", key, described(*list.get(i))));
    std::string const& word = text->get();
    if (std::find(allowed.begin(), allowed.end(), word) == allowed.end())
      throw SceneError(place(key, i), fmt::format("unknown {} '{}'{} ({})", what, word, did_you_mean(word, allowed), see.empty() ? "known: " + listed(allowed) : see));
    if (std::find(words.begin(), words.end(), word) != words.end()) throw SceneError(place(key, i), fmt::format("{}: '{}' is there twice", key, word));
    words.push_back(word);
  }
  return words;
}
std::vector<double> SceneTable::numbers(std::string const& key, long size) const {
  return numbers_in(list_of(value_of(*document_, path_, *this, key), place(key), key, "a list of numbers"), place(key), key, size, document_->name);
}
Eigen::Vector3d SceneTable::vector(std::string const& key) const { return Eigen::Vector3d(numbers(key, 3).data()); }
Eigen::MatrixXd SceneTable::matrix(std::string const& key, long n) const {
  auto const& rows = list_of(value_of(*document_, path_, *this, key), place(key), key, "a list of rows");
  if (rows.size() != static_cast<std::size_t>(n)) fail(key, fmt::format("{}: {} rows are expected, found {}", key, n, rows.size()));
  Eigen::MatrixXd out(n, n);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    Place const where = place(key, i);
    auto const row = numbers_in(list_of(*rows.get(i), where, key, "a list of numbers in each row"), where, key, n, document_->name);
    out.row(static_cast<Eigen::Index>(i)) = Eigen::Map<Eigen::RowVectorXd const>(row.data(), n);
  }
  return out;
}
bool SceneTable::is_matrix(std::string const& key) const {
  if (!has(key)) return false;
  auto const* const list = document_->find(path_)->get(key)->as_array();
  return list && !list->empty() && list->get(0)->is_array();
}
bool SceneTable::is_text(std::string const& key) const { return has(key) && document_->find(path_)->get(key)->is_string(); }

namespace {

template <class Value>
void write_back(detail::SceneDocument& document, std::vector<std::string> path, std::string const& key, Value&& value) {
  document.make(path).insert_or_assign(key, std::forward<Value>(value));
  path.push_back(key);
  document.defaults.push_back(std::move(path));
}

}  // namespace

void SceneTable::set(std::string const& key, double value) { write_back(*document_, path_, key, value); }
void SceneTable::set(std::string const& key, long value) { write_back(*document_, path_, key, static_cast<std::int64_t>(value)); }
void SceneTable::set(std::string const& key, bool value) { write_back(*document_, path_, key, value); }
void SceneTable::set(std::string const& key, std::string const& value) { write_back(*document_, path_, key, value); }
void SceneTable::set(std::string const& key, std::vector<double> const& values) {
  toml::array list;
  for (double const v : values) list.push_back(v);
  write_back(*document_, path_, key, std::move(list));
}
void SceneTable::set(std::string const& key, Eigen::MatrixXd const& values) {
  toml::array rows;
  for (Eigen::Index i = 0; i < values.rows(); ++i) {
    toml::array row;
    for (Eigen::Index j = 0; j < values.cols(); ++j) row.push_back(values(i, j));
    rows.push_back(std::move(row));
  }
  write_back(*document_, path_, key, std::move(rows));
}
void SceneTable::set(std::string const& key, std::vector<std::string> const& values) {
  toml::array list;
  for (auto const& v : values) list.push_back(v);
  write_back(*document_, path_, key, std::move(list));
}

// ---- SceneFile

SceneFile SceneFile::read(std::string const& path, std::vector<std::string> const& overrides) {
  namespace fs = std::filesystem;
  std::error_code none;
  if (!fs::exists(path, none)) {
    std::vector<std::string> beside;
    fs::path const folder = fs::path(path).parent_path();
    for (fs::directory_iterator it(folder.empty() ? fs::path(".") : folder, none), end; !none && it != end; it.increment(none))
      if (it->path().extension() == ".toml") beside.push_back((folder / it->path().filename()).string());
    throw SceneError({path}, "there is no such file" + did_you_mean(path, beside));
  }
  if (!fs::is_regular_file(path, none)) throw SceneError({path}, "a file is expected");
  std::ifstream in(path, std::ios::binary);
  if (!in) throw FileError(path + ": cannot be read");
  auto const size = fs::file_size(path, none);
  if (!none && size > largest_file) throw SceneError({path}, fmt::format("a scene has at most {} bytes, this file has {}", largest_file, size));
  std::string const text{std::istreambuf_iterator<char>(in), {}};
  if (in.bad()) throw FileError(path + ": cannot be read");
  return parse(text, path, overrides);
}

SceneFile SceneFile::parse(std::string_view text, std::string const& name, std::vector<std::string> const& overrides) {
  auto document = std::make_shared<detail::SceneDocument>();
  document->name = name;
  document->root = parse_toml(text, name);
  document->last_line = 1 + static_cast<unsigned>(std::count(text.begin(), text.end(), '\n'));
  for (auto const& argument : overrides) {
    try {
      merge(document->root, read_override(argument), "--set " + argument);
    } catch (toml::parse_error const& error) {
      throw parse_failure(error, "--set " + argument);
    }
  }
  return SceneFile(std::move(document));
}

SceneTable SceneFile::section(std::string const& name) const {
  toml::node const* const node = document_->root.get(name);
  if (node && !node->is_table()) throw SceneError(place_of(node->source(), document_->name), fmt::format("{}: a section [{}] is expected, found {}", name, name, described(*node)));
  return {document_, {name}};
}
void SceneFile::allow(std::vector<std::string> const& sections) const { SceneTable(document_, {}).allow(sections); }
std::string const& SceneFile::name() const { return document_->name; }

namespace {

/// A table and those in it: keys of the file in its order, then overrides, then defaults.
void write_table(detail::SceneDocument const& document, toml::table const& table, std::vector<std::string> const& path, std::string& out) {
  struct Entry {
    std::size_t rank;
    unsigned line, column;
    std::string key;
    toml::node const* node;
  };
  std::vector<Entry> entries;
  for (auto const& [key, node] : table) {
    std::vector<std::string> whole = path;
    whole.emplace_back(key.str());
    auto const written = std::find(document.defaults.begin(), document.defaults.end(), whole);
    auto const begin = node.source().begin;
    bool const of_file = node.source().path && *node.source().path == document.name;
    std::size_t const rank = written != document.defaults.end() ? 2 + static_cast<std::size_t>(written - document.defaults.begin()) : of_file ? 0 : 1;
    entries.push_back({rank, begin.line, begin.column, std::string(key.str()), &node});
  }
  std::sort(entries.begin(), entries.end(), [](Entry const& a, Entry const& b) { return std::tie(a.rank, a.line, a.column, a.key) < std::tie(b.rank, b.line, b.column, b.key); });
  std::string header;
  for (auto const& key : path) header += (header.empty() ? "" : ".") + key_in_toml(key);
  out += (out.empty() ? "[" : "\n[") + header + "]\n";
  for (auto const& e : entries)
    if (!e.node->is_table()) out += key_in_toml(e.key) + " = " + in_toml(*e.node) + "\n";
  for (auto const& e : entries)
    if (auto const* inner = e.node->as_table()) {
      std::vector<std::string> deeper = path;
      deeper.push_back(e.key);
      write_table(document, *inner, deeper, out);
    }
}

}  // namespace

std::string SceneFile::written() const {
  std::string out;
  std::vector<std::string> order{"scene", "system", "initial", "method", "run", "output"};
  for (auto const& [key, node] : document_->root)
    if (std::find(order.begin(), order.end(), key.str()) == order.end()) order.emplace_back(key.str());
  for (auto const& name : order)
    if (auto const* node = document_->root.get(name); node && node->is_table()) write_table(*document_, *node->as_table(), {name}, out);
  return out;
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
