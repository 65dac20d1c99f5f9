// The algebra of a group told by its name: "SE(2)", "SO(3) x R^1", "SL(2) |x R^2".
#pragma once

#include <cctype>
#include <string_view>

#include "actio/any_group/group_families.hpp"
#include "actio/numbers/nearest_name.hpp"

namespace actio::systems {

/// A name that is no group's.
struct UnknownGroup : Error {
  using Error::Error;
};

namespace detail {

/// `R^n, SO(n), ...`
inline std::string group_patterns() {
  std::vector<std::string> all;
  for (auto const& family : group_families()) all.push_back(family.pattern());
  return listed(all);
}

/// The group that a word without a meaning was probably meant to be: by its letters, great or small, and its
/// number; empty where none is near.
std::string nearest_group(std::string_view word);

/// Reads the name of a group:
///
///     product    := semidirect { "x" semidirect }
///     semidirect := single { "|x" R^n }
///     single     := name | "(" product ")"
class GroupName {
 public:
  /// @throws UnknownGroup, OutsideDomain  as `named_algebra`
  static GroupOfMatrices read(std::string_view text);

 private:
  std::string_view text_;
  std::size_t at_ = 0;

  explicit GroupName(std::string_view text) : text_(text) {}

  void skip_spaces() {
    while (at_ < text_.size() && text_[at_] == ' ') ++at_;
  }
  bool at_end() {
    skip_spaces();
    return at_ == text_.size();
  }
  bool take(std::string_view word);
  template <class Is>
  std::string_view while_letters(Is is) {
    std::size_t const from = at_;
    while (at_ < text_.size() && is(static_cast<unsigned char>(text_[at_]))) ++at_;
    return text_.substr(from, at_ - from);
  }
  [[noreturn]] void refuse(std::string const& expected);

  GroupOfMatrices product();

  GroupOfMatrices semidirect();

  GroupOfMatrices single();

  GroupOfMatrices member(GroupFamily const& family);

  static GroupOfMatrices of_order(GroupFamily const& family, double number, std::string const& name);

  [[noreturn]] void refuse_unknown();
};

/// Names of the components where the group has its own.
std::vector<std::string> own_components(std::string const& group);

}  // namespace detail

/// The algebra of a group of `actio list groups`, in the basis of the library's type: "R^3", "SO(4)",
/// "SE(2)", "GL(2)", "SL(3)", "U(2)", "SU(2)" (the coordinates of unit quaternions), "SU(3)", "Sp(4)",
/// "Aff(1)", "Heisenberg", direct products "SO(3) x SE(2) x R^1" and semidirect products "SL(2) |x R^2", n
/// being the rows of the matrices; with brackets where a factor is a product.
///
/// Matrices are real: U(n) and SU(n) as ((A, -B), (B, A)), R^n as ((1, x), (0, 1)), products as block
/// diagonal matrices. Components are `w1 w2 w3` on SO(3), `w v1 v2` on SE(2), `w1 w2 w3 v1 v2 v3` on SE(3),
/// `x1`, `x2`, ... elsewhere.
///
/// \snippet reduction.cpp named_algebra
/// @throws UnknownGroup   where the name is no group's, with the nearest one
/// @throws OutsideDomain  where the group has more than 64 dimensions, and where its number is not one of its
///                        family
MatrixAlgebra named_algebra(std::string_view name);

}  // namespace actio::systems
