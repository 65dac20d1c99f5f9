// What a discrete motion tends to as the step goes to zero: steps, errors and groups for the fits of orders.
// In double, where the fits are made.
#pragma once

#include <vector>

#include "models/models.hpp"

namespace actio::checks {

/// Groups of the fits: one of each kind, commutative brackets aside.
inline std::vector<SpannedGroup> const& limit_groups() {
  static std::vector<SpannedGroup> const groups = {spanned("SO(3)", SO<3>{}), spanned("SE(2)", SE<2>{}),
                                                   spanned("Aff(1)", Aff1{})};
  return groups;
}
/// A duration, taken in more and more steps: fine enough for the leading term, with errors far above
/// rounding.
struct Refinement {
  double duration;
  std::vector<int> counts;

  std::vector<double> step_lengths() const {
    std::vector<double> steps;
    for (int n : counts) steps.push_back(duration / n);
    return steps;
  }
  /// One error for each number of steps: `error(n, h)`.
  template <class Error>
  std::vector<double> errors_of(Error const& error) const {
    std::vector<double> errors;
    for (int n : counts) errors.push_back(to_double(error(n, duration / n)));
    return errors;
  }
};
/// Half a unit of time in 32, 64, ..., 1024 steps: for second order.
inline Refinement const by_halves{0.5, {32, 64, 128, 256, 512, 1024}};

/// The velocity \f$\dot gg^{-1}\f$ in a Lagrangian, at any configuration.
template <class L>
auto reduced(L const& lagrangian) {
  return [lagrangian](auto const& xi) {
    using T = std::decay_t<decltype(xi.coordinates[0])>;
    return lagrangian(State<SpannedGroup, T>{identity<T>(xi.group), xi});
  };
}

}  // namespace actio::checks
