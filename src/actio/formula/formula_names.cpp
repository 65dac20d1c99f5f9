#include "actio/formula/formula_names.hpp"

namespace actio {

namespace detail {

std::string meant_name(std::string_view word, std::vector<std::string> const& known) {
  auto const lower = [](char c) { return c >= 'A' && c <= 'Z' ? char(c - 'A' + 'a') : c; };
  for (auto const& name : known)
    if (std::equal(name.begin(), name.end(), word.begin(), word.end(),
                   [&](char a, char b) { return lower(a) == lower(b); }))
      return "; did you mean '" + name + "'?";
  return word.size() < 2 ? "" : did_you_mean(word, known);
}

void FormulaNames::require_free(std::string_view name, std::size_t position) const {
  if (!is_name(name))
    throw FormulaError(position, "'" + shown(name) +
                                     "' is no name of a number; one is a letter or _ "
                                     "and then letters, digits and _");
  if (has_a_meaning(name))
    throw FormulaError(position,
                       "the name '" + shown(name) + "' has a meaning of its own in formulas; take another");
  if (entries_.contains(name))
    throw FormulaError(position, "the name '" + shown(name) + "' stands for a number already; take another" +
                                     (smooth_ ? "" : "; 'is equal to' is =="));
}

std::optional<FormulaNames::Entry> FormulaNames::use(std::string_view name) {
  auto const found = entries_.find(name);
  if (found == entries_.end()) return std::nullopt;
  used_.emplace(name);
  return found->second;
}

std::optional<Operation> FormulaNames::function(Token const& name) const {
  auto const function = function_called(name.text);
  if (function && smooth_ && !is_smooth(*function))
    throw FormulaError(name.position, "'" + std::string(name.text) +
                                          "' has kinks or jumps, and this formula is smooth, since it is "
                                          "differentiated; |x| is smooth as sqrt(x^2 + e^2) with a small e");
  return function;
}

void FormulaNames::refuse(Token const& name, bool called) const {
  std::string const quoted = "'" + shown(name.text) + "'";
  if (called)
    throw FormulaError(name.position, "unknown function " + quoted + did_you_mean(name.text, functions()) +
                                          " (known: " + listed(functions()) + ")");
  std::vector<std::string> all = numbers();
  std::string const known = briefly(all);
  for (auto const& function : functions()) all.push_back(function);
  throw FormulaError(name.position,
                     "unknown name " + quoted + meant_name(name.text, all) + " (known: " + known + ")");
}

std::vector<std::string> FormulaNames::functions() const {
  std::vector<std::string> all;
  for (int i = 0; i < operations; ++i)
    if (auto const o = static_cast<Operation>(i); is_function(o) && (is_smooth(o) || !smooth_))
      all.emplace_back(name_of(o));
  return all;
}

std::vector<std::string> FormulaNames::numbers() const {
  std::vector<std::string> all(known_.begin(), known_.end());
  all.emplace_back("pi");
  return all;
}

std::string FormulaNames::briefly(std::vector<std::string> const& names) {
  constexpr std::size_t most = 20;
  if (names.size() <= most) return listed(names);
  std::vector<std::string> const first(names.begin(), names.begin() + most);
  return listed(first) + ", and " + std::to_string(names.size() - most) + " more";
}

}  // namespace detail

}  // namespace actio
