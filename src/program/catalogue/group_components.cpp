// How scenes name the velocity on a group: components, and the matrix that they make.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "actio/any_group/named_algebra.hpp"
#include "program/catalogue/groups.hpp"

namespace actio::scene {
namespace {

constexpr int most_rows_told = 6;

/// `-w`, `x1 + 2*x2`, `0`.
std::string entry_in_words(systems::MatrixAlgebra const& algebra, int row, int column) {
  std::string out;
  for (auto const& e : algebra.entries) {
    if (e.row != row || e.column != column) continue;
    std::string const& name = algebra.components[static_cast<std::size_t>(e.direction)];
    out += out.empty() ? (e.value < 0 ? "-" : "") : (e.value < 0 ? " - " : " + ");
    out += std::abs(e.value) == 1 ? name : fmt::format("{:g}*{}", std::abs(e.value), name);
  }
  return out.empty() ? "0" : out;
}

std::vector<std::string> velocity_in_words(systems::MatrixAlgebra const& algebra) {
  std::vector<std::string> rows;
  if (algebra.size > most_rows_told) return rows;
  for (int i = 0; i < algebra.size; ++i) {
    std::vector<std::string> row;
    for (int j = 0; j < algebra.size; ++j) row.push_back(entry_in_words(algebra, i, j));
    rows.push_back(fmt::format("[{}]", fmt::join(row, ", ")));
  }
  return rows;
}

std::optional<systems::MatrixAlgebra> algebra_of_name(std::string_view name) {
  try {
    return systems::named_algebra(name);
  } catch (Error const&) {
    return {};
  }
}

/// The names of the components where the group with this number in place of n has its own.
std::string own_components_of_member(std::string name, int number) {
  std::size_t const at = name.find("(n)");
  if (at == std::string::npos) return "";
  name.replace(at, 3, fmt::format("({})", number));
  auto const own = actio::systems::detail::own_components(name);
  return own.empty() ? "" : fmt::format(", {} on {}", fmt::join(own, " "), name);
}

}  // namespace

std::optional<NamedGroup> named_group(std::string_view word) {
  auto algebra = algebra_of_name(word);
  if (!algebra && !find_groups(word).empty())
    algebra = algebra_of_name(actio::systems::detail::nearest_group(word));
  if (!algebra) return {};
  return NamedGroup{algebra->name, algebra->components, velocity_in_words(*algebra)};
}

std::string components_of(LibraryGroup const& group) {
  if (auto const algebra = algebra_of_name(group.name))
    return fmt::format("{}", fmt::join(algebra->components, " "));
  std::string out = "x1 x2 ...";
  for (int number = 2; number < 5; ++number) out += own_components_of_member(group.name, number);
  return out;
}

}  // namespace actio::scene
