// One table of a scene, read key by key.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "actio/numbers/nearest_name.hpp"
#include "actio/scene/scene_document.hpp"
#include "actio/scene/scene_file.hpp"

namespace actio::scene {
namespace {

using detail::described, detail::place_of;

double finite_number(toml::node const& node, Place const& place, std::string const& key) {
  // A whole number beyond 2^53 is rounded, as any decimal is.
  auto const* const whole = node.as_integer();
  auto const* const real = node.as_floating_point();
  if (!whole && !real)
    throw SceneError(place, fmt::format("{}: a number is expected, found {}", key, described(node)));
  double const value = whole ? static_cast<double>(whole->get()) : real->get();
  if (!std::isfinite(value))
    throw SceneError(place, fmt::format("{}: a finite number is expected, found {}", key, described(node)));
  return value;
}

toml::node const& value_of(detail::SceneDocument& document, std::vector<std::string> const& path,
                           std::string const& key, SceneTable const& table) {
  toml::node const* const node = document.value(path, key);
  if (!node) throw SceneError(table.place(), "[" + table.name() + "] needs '" + key + "'");
  return *node;
}

toml::array const& list_of(toml::node const& node, Place const& place, std::string const& key,
                           std::string const& expected) {
  auto const* const list = node.as_array();
  if (!list)
    throw SceneError(place, fmt::format("{}: {} is expected, found {}", key, expected, described(node)));
  return *list;
}

std::vector<double> numbers_in(toml::array const& list, Place const& place, std::string const& key, long size,
                               std::string const& file) {
  if (size >= 0 && list.size() != static_cast<std::size_t>(size))
    throw SceneError(place, fmt::format("{}: {} numbers are expected, found {}", key, size, list.size()));
  std::vector<double> values;
  for (auto const& item : list) values.push_back(finite_number(item, place_of(item.source(), file), key));
  return values;
}

Eigen::MatrixXd matrix_in(toml::node const& node, Place const& place, std::string const& key, long n,
                          std::string const& file) {
  auto const& rows = list_of(node, place, key, "a list of rows");
  if (rows.size() != static_cast<std::size_t>(n))
    throw SceneError(place, fmt::format("{}: {} rows are expected, found {}", key, n, rows.size()));
  Eigen::MatrixXd out(n, n);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    Place const where = place_of(rows[i].source(), file);
    auto const row =
        numbers_in(list_of(rows[i], where, key, "a list of numbers in each row"), where, key, n, file);
    out.row(static_cast<Eigen::Index>(i)) = Eigen::Map<Eigen::RowVectorXd const>(row.data(), n);
  }
  return out;
}

[[noreturn]] void fail_unknown(Place const& place, std::string const& what, std::string const& word,
                               std::vector<std::string> const& allowed, std::string const& see) {
  throw SceneError(place,
                   fmt::format("unknown {} '{}'{} ({})", what, shown(word), did_you_mean(word, allowed),
                               see.empty() ? "known: " + listed(allowed) : see));
}

/// `; write 2` for 2.0, which is a whole number in another dress.
std::string without_point(toml::node const& node) {
  auto const* const real = node.as_floating_point();
  constexpr double most = 9007199254740992;  // 2^53: beyond it the number may be another one
  if (!real || !(std::abs(real->get()) <= most) || real->get() != std::round(real->get())) return "";
  return fmt::format("; write {}", static_cast<std::int64_t>(real->get()));
}

/// Whether a text stands in the file as it is shows in its width: with a quote on either side, and none of
/// its characters written as several.
TextPlace text_place_of(toml::node const* node, Place const& place) {
  auto const* const text = node ? node->as_string() : nullptr;
  if (!text) return {place, false};
  auto const [begin, end] = std::pair(node->source().begin, node->source().end);
  auto const characters =
      std::count_if(text->get().begin(), text->get().end(), [](char c) { return (c & 0xC0) != 0x80; });
  // A bare word of the command line has no quotes there.
  bool const bare = place.file.starts_with("--set ") && place.file.ends_with("=" + text->get());
  return {place, !bare && begin.line == end.line &&
                     end.column == begin.column + static_cast<unsigned>(characters) + 2};
}

bool is_before(toml::key const& a, toml::key const& b) {
  auto const p = a.source().begin, q = b.source().begin;
  return std::pair(p.line, p.column) < std::pair(q.line, q.column);
}

}  // namespace

std::string SceneTable::name() const {
  std::string out;
  for (auto const& key : path_) out += (out.empty() ? "" : ".") + key;
  return out;
}

void SceneTable::allow(std::vector<std::string> const& keys,
                       std::function<std::string(std::string const& key)> const& more) const {
  toml::table const* const table = document_->table(path_);
  if (!table) return;
  // The first in the file, not in the alphabet.
  toml::key const* first = nullptr;
  for (auto const& [key, node] : *table)
    if (std::find(keys.begin(), keys.end(), key.str()) == keys.end() && (!first || is_before(key, *first)))
      first = &key;
  if (!first) return;
  std::string const word(first->str()), what = path_.empty() ? "section" : "key of [" + name() + "]",
                                        note = more ? more(word) : "";
  Place const place = place_of(first->source(), document_->name);
  if (!note.empty()) throw SceneError(place, fmt::format("unknown {} '{}'{}", what, shown(word), note));
  fail_unknown(place, what, word, keys, keys.empty() ? "none is known here" : "");
}

std::vector<std::string> SceneTable::keys() const {
  std::vector<toml::key const*> found;
  if (toml::table const* const table = document_->table(path_))
    for (auto const& [key, node] : *table) found.push_back(&key);
  std::sort(found.begin(), found.end(), [](auto const* a, auto const* b) { return is_before(*a, *b); });
  std::vector<std::string> out;
  for (auto const* key : found) out.emplace_back(key->str());
  return out;
}

bool SceneTable::has(std::string const& key) const { return document_->value(path_, key); }

Place SceneTable::place() const {
  // What was missed in a table that only the command line speaks of is missed in the file, but for a value in
  // braces.
  toml::table const* const table = document_->table(path_);
  if (table && table->is_inline() && table->source().begin) return place_of(table->source(), document_->name);
  if (table && table->source().begin && table->source().path && *table->source().path == document_->name)
    return place_of(table->source(), document_->name);
  return {document_->name, document_->last_line, 1};
}
Place SceneTable::place(std::string const& key) const {
  toml::node const* const node = document_->value(path_, key);
  return node && node->source().begin ? place_of(node->source(), document_->name) : place();
}
Place SceneTable::place(std::string const& key, std::size_t item) const {
  toml::node const* const node = document_->value(path_, key);
  toml::array const* const list = node ? node->as_array() : nullptr;
  return list && item < list->size() ? place_of(list->get(item)->source(), document_->name) : place(key);
}
TextPlace SceneTable::text_place(std::string const& key) const {
  return text_place_of(document_->value(path_, key), place(key));
}
TextPlace SceneTable::text_place(std::string const& key, std::size_t item) const {
  toml::node const* const node = document_->value(path_, key);
  toml::array const* const list = node ? node->as_array() : nullptr;
  return text_place_of(list ? list->get(item) : nullptr, place(key, item));
}
void SceneTable::fail(std::string const& key, std::string const& what) const {
  throw SceneError(place(key), what);
}

double SceneTable::number(std::string const& key) const {
  return finite_number(value_of(*document_, path_, key, *this), place(key), key);
}
double SceneTable::positive(std::string const& key) const {
  double const value = number(key);
  if (!(value > 0)) fail(key, fmt::format("{}: a number > 0 is expected, found {}", key, value));
  return value;
}
long SceneTable::integer(std::string const& key, long least, long most) const {
  auto const& node = value_of(*document_, path_, key, *this);
  auto const* const value = node.as_integer();
  if (!value)
    fail(key, fmt::format("{}: a whole number is expected, found {}{}", key, described(node),
                          without_point(node)));
  if (value->get() < least || value->get() > most)
    fail(key, fmt::format("{}: a whole number from {} to {} is expected, found {}", key, least, most,
                          value->get()));
  return static_cast<long>(value->get());
}
bool SceneTable::boolean(std::string const& key) const {
  auto const& node = value_of(*document_, path_, key, *this);
  if (!node.is_boolean())
    fail(key, fmt::format("{}: true or false is expected, found {}", key, described(node)));
  return *node.value<bool>();
}
std::string SceneTable::text(std::string const& key) const {
  auto const& node = value_of(*document_, path_, key, *this);
  if (!node.is_string()) fail(key, fmt::format("{}: a text is expected, found {}", key, described(node)));
  return *node.value<std::string>();
}
std::string SceneTable::choice(std::string const& key, std::string const& what,
                               std::vector<std::string> const& allowed, std::string const& see) const {
  std::string const word = text(key);
  if (std::find(allowed.begin(), allowed.end(), word) == allowed.end())
    fail_unknown(place(key), what, word, allowed, see);
  return word;
}

std::vector<std::string> SceneTable::texts(std::string const& key) const {
  std::vector<std::string> out;
  for (auto const& item :
       list_of(value_of(*document_, path_, key, *this), place(key), key, "a list of texts")) {
    auto const* const text = item.as_string();
    if (!text)
      throw SceneError(place_of(item.source(), document_->name),
                       fmt::format("{}: a text is expected, found {}", key, described(item)));
    out.push_back(text->get());
  }
  return out;
}
std::vector<std::string> SceneTable::choices(std::string const& key, std::string const& what,
                                             std::vector<std::string> const& allowed,
                                             std::string const& see) const {
  std::vector<std::string> const words = texts(key);
  if (words.empty())
    fail(key, fmt::format("{}: at least one {} is expected ({})", key, what,
                          see.empty() ? "known: " + listed(allowed) : see));
  for (std::size_t i = 0; i < words.size(); ++i) {
    if (std::find(allowed.begin(), allowed.end(), words[i]) == allowed.end())
      fail_unknown(place(key, i), what, words[i], allowed, see);
    if (std::find(words.begin(), words.begin() + static_cast<long>(i), words[i]) !=
        words.begin() + static_cast<long>(i))
      throw SceneError(place(key, i), fmt::format("{}: '{}' is there twice", key, words[i]));
  }
  return words;
}
std::vector<double> SceneTable::numbers(std::string const& key, long size) const {
  return numbers_in(list_of(value_of(*document_, path_, key, *this), place(key), key, "a list of numbers"),
                    place(key), key, size, document_->name);
}
std::vector<bool> SceneTable::booleans(std::string const& key, long size) const {
  std::string const wanted = fmt::format("a list of {} times true or false", size);
  auto const& list = list_of(value_of(*document_, path_, key, *this), place(key), key, wanted);
  std::vector<bool> out;
  for (auto const& item : list) {
    if (!item.is_boolean())
      throw SceneError(place_of(item.source(), document_->name),
                       fmt::format("{}: true or false is expected, found {}", key, described(item)));
    out.push_back(*item.value<bool>());
  }
  if (out.size() != static_cast<std::size_t>(size))
    fail(key, fmt::format("{}: {} is expected, found {}", key, wanted, out.size()));
  return out;
}
Eigen::Vector3d SceneTable::vector(std::string const& key) const {
  return Eigen::Vector3d(numbers(key, 3).data());
}
Eigen::MatrixXd SceneTable::matrix(std::string const& key, long n) const {
  return matrix_in(value_of(*document_, path_, key, *this), place(key), key, n, document_->name);
}
std::vector<std::vector<double>> SceneTable::rows(std::string const& key, long size) const {
  auto const& list = list_of(value_of(*document_, path_, key, *this), place(key), key, "a list of rows");
  std::vector<std::vector<double>> out;
  for (std::size_t i = 0; i < list.size(); ++i) {
    Place const where = place(key, i);
    out.push_back(numbers_in(list_of(list[i], where, key, "a list of numbers in each row"), where, key, size,
                             document_->name));
  }
  return out;
}
std::vector<Eigen::MatrixXd> SceneTable::matrices(std::string const& key) const {
  auto const& list = list_of(value_of(*document_, path_, key, *this), place(key), key, "a list of matrices");
  if (list.empty()) fail(key, key + ": at least one matrix is expected, found none");
  std::vector<Eigen::MatrixXd> out;
  for (std::size_t i = 0; i < list.size(); ++i) {
    auto const& rows = list_of(list[i], place(key, i), key, "a matrix, a list of rows,");
    long const n = out.empty() ? static_cast<long>(rows.size()) : out.front().rows();
    out.push_back(matrix_in(list[i], place(key, i), key, n, document_->name));
  }
  return out;
}
bool SceneTable::is_matrix(std::string const& key) const {
  toml::node const* const node = document_->value(path_, key);
  auto const* const list = node ? node->as_array() : nullptr;
  return list && !list->empty() && list->get(0)->is_array();
}
bool SceneTable::is_text(std::string const& key) const {
  toml::node const* const node = document_->value(path_, key);
  return node && node->is_string();
}
bool SceneTable::is_table(std::string const& key) const {
  toml::node const* const node = document_->value(path_, key);
  return node && node->is_table();
}
SceneTable SceneTable::inside(std::string const& key) const {
  auto path = path_;
  path.push_back(key);
  return {document_, std::move(path)};
}

void SceneTable::set(std::string const& key, double value) { document_->set(path_, key, value); }
void SceneTable::set(std::string const& key, long value) {
  document_->set(path_, key, static_cast<std::int64_t>(value));
}
void SceneTable::set(std::string const& key, bool value) { document_->set(path_, key, value); }
void SceneTable::set(std::string const& key, std::string const& value) { document_->set(path_, key, value); }
void SceneTable::set(std::string const& key, std::vector<double> const& values) {
  toml::array list;
  for (double const v : values) list.push_back(v);
  document_->set(path_, key, std::move(list));
}
void SceneTable::set(std::string const& key, Eigen::MatrixXd const& values) {
  toml::array rows;
  for (Eigen::Index i = 0; i < values.rows(); ++i) {
    toml::array row;
    for (Eigen::Index j = 0; j < values.cols(); ++j) row.push_back(values(i, j));
    rows.push_back(std::move(row));
  }
  document_->set(path_, key, std::move(rows));
}
void SceneTable::set(std::string const& key, std::vector<std::string> const& values) {
  toml::array list;
  for (auto const& v : values) list.push_back(v);
  document_->set(path_, key, std::move(list));
}
void SceneTable::set(std::string const& key, std::vector<bool> const& values) {
  toml::array list;
  for (bool const v : values) list.push_back(v);
  document_->set(path_, key, std::move(list));
}

}  // namespace actio::scene
