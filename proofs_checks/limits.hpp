// What a discrete motion tends to as the step goes to zero: steps, errors and groups for the fits of orders. In double, where the fits are made.
#pragma once

#include <concepts>
#include <vector>

#include "models.hpp"

namespace actio::checks {

template <class S>
inline constexpr bool fits_orders = std::same_as<S, double>;

/// Groups of the fits: one of each kind, commutative brackets aside.
inline std::vector<SpannedGroup> const& limit_groups() {
  static std::vector<SpannedGroup> const groups = {spanned("SO(3)", SO<3>{}), spanned("SE(2)", SE<2>{}), spanned("Aff(1)", Aff1{})};
  return groups;
}
/// Half a unit of time in 32, 64, ..., 1024 steps: fine enough for the leading term, with errors far above rounding.
constexpr double duration = 0.5;
inline std::vector<int> const& step_counts() {
  static std::vector<int> const counts = {32, 64, 128, 256, 512, 1024};
  return counts;
}
inline std::vector<double> step_lengths() {
  std::vector<double> steps;
  for (int n : step_counts()) steps.push_back(duration / n);
  return steps;
}
/// One error for each number of steps.
template <class Error>
std::vector<double> errors_of(Error const& error) {
  std::vector<double> errors;
  for (int n : step_counts()) errors.push_back(to_double(error(n, duration / n)));
  return errors;
}
/// The velocity \f$\dot gg^{-1}\f$ as a Lagrangian sees it, no matter where.
template <class L>
auto reduced(L const& lagrangian) {
  return [lagrangian](auto const& xi) {
    using T = std::decay_t<decltype(xi.coordinates[0])>;
    return lagrangian(State<SpannedGroup, T>{identity<T>(xi.group), xi});
  };
}

}  // namespace actio::checks
