// The names that a formula may use: of inputs, constants and definitions, and of functions.
#pragma once

#include <algorithm>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "actio/formula/formula_error.hpp"
#include "actio/formula/formula_text.hpp"
#include "actio/formula/operation.hpp"
#include "actio/formula/tape_entries.hpp"
#include "actio/numbers/nearest_name.hpp"

namespace actio::detail {

/// The function with this name.
inline std::optional<Operation> function_called(std::string_view name) {
  for (int i = 0; i < operations; ++i)
    if (auto const o = static_cast<Operation>(i); is_function(o) && name_of(o) == name) return o;
  return std::nullopt;
}
/// Whether formulas know a name: no number can have it.
inline bool has_a_meaning(std::string_view name) { return name == "pi" || function_called(name).has_value(); }

/// `; did you mean 'X'?`: the name that differs by the case of letters alone, else for words of two letters
/// and more the nearest; nothing where there is none.
std::string meant_name(std::string_view word, std::vector<std::string> const& known);

/// Names of numbers, and which entry of a tape each is.
class FormulaNames {
 public:
  using Entry = TapeEntries::Entry;

  /// @param smooth  whether functions with kinks or jumps are refused
  explicit FormulaNames(bool smooth) : smooth_(smooth) {}

  /// The function with this name; nothing where there is none.
  /// @throws FormulaError  where it has kinks or jumps and the formula is smooth
  std::optional<Operation> function(Token const& name) const;

  /// Refuses a name that cannot be given to a number, or that another one has.
  /// @param position  where to point
  void require_free(std::string_view name, std::size_t position) const;
  /// Gives an entry a name that is free.
  void add(std::string_view name, Entry entry) { entries_.emplace(name, entry), known_.emplace(name); }
  /// Takes a name among those that are known, without a number yet.
  void offer(std::string_view name) { known_.emplace(name); }
  /// Whether a number has it.
  bool has(std::string_view name) const { return entries_.contains(name); }
  /// The entry with this name, which is used now.
  std::optional<Entry> use(std::string_view name);
  /// The names that were used.
  std::set<std::string, std::less<>> const& used() const { return used_; }

  /// Says why a name has no meaning.
  /// @param called  whether a bracket follows it
  [[noreturn]] void refuse(Token const& name, bool called) const;

 private:
  std::vector<std::string> functions() const;
  std::vector<std::string> numbers() const;
  static std::string briefly(std::vector<std::string> const& names);

  bool smooth_;
  std::map<std::string, Entry, std::less<>> entries_;
  std::set<std::string, std::less<>> used_, known_;
};

}  // namespace actio::detail
