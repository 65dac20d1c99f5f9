// The values of a table of a scene, each read as what it is to be.
#include <Eigen/Core>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "actio/numbers/nearest_name.hpp"
#include "program/document/document.hpp"
#include "program/document/file.hpp"

namespace actio::scene {
namespace {

using detail::described, detail::fail_unknown, detail::place_of;

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

/// A formula: a text, or a number, which is one without variables.
std::string formula_in(toml::node const& node, Place const& place, std::string const& key) {
  if (auto const* const text = node.as_string()) return text->get();
  if (!node.is_number())
    throw SceneError(
        place, fmt::format("{}: a formula is expected, a text or a number, found {}", key, described(node)));
  return fmt::format("{}", finite_number(node, place, key));
}

/// `; write 2` for 2.0, which is a whole number in another dress.
std::string without_point(toml::node const& node) {
  auto const* const real = node.as_floating_point();
  constexpr double most = 9007199254740992;  // 2^53: beyond it the number may be another one
  if (!real || !(std::abs(real->get()) <= most) || real->get() != std::round(real->get())) return "";
  return fmt::format("; write {}", static_cast<std::int64_t>(real->get()));
}

}  // namespace

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
std::vector<std::string> SceneTable::formulas(std::string const& key) const {
  std::vector<std::string> out;
  for (auto const& item :
       list_of(value_of(*document_, path_, key, *this), place(key), key, "a list of formulas"))
    out.push_back(formula_in(item, place_of(item.source(), document_->name), key));
  return out;
}
std::string SceneTable::formula(std::string const& key) const {
  return formula_in(value_of(*document_, path_, key, *this), place(key), key);
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
Eigen::MatrixXd SceneTable::rows(std::string const& key, long size) const {
  auto const& list = list_of(value_of(*document_, path_, key, *this), place(key), key, "a list of rows");
  Eigen::MatrixXd out(static_cast<Eigen::Index>(list.size()), size);
  for (std::size_t i = 0; i < list.size(); ++i) {
    Place const where = place(key, i);
    auto const row = numbers_in(list_of(list[i], where, key, "a list of numbers in each row"), where, key,
                                size, document_->name);
    out.row(static_cast<Eigen::Index>(i)) = Eigen::Map<Eigen::RowVectorXd const>(row.data(), size);
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

}  // namespace actio::scene
