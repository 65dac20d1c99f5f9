// One table of a scene: which keys are there and where, and defaults that are written back.
#include <Eigen/Core>

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "program/document/document.hpp"
#include "program/document/file.hpp"

namespace actio::scene {
namespace {

using detail::fail_unknown, detail::place_of;

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
std::string SceneTable::found(std::string const& key) const {
  toml::node const* const node = document_->value(path_, key);
  return node ? detail::described(*node) : "nothing";
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
