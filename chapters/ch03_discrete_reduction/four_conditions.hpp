// The four conditions of Theorem 3.2.1 at the middle one of three pictures of a body that turns.
#pragma once

#include <array>

#include "actio/groups/rotations.hpp"
#include "actio/reduction/discrete_euler_lagrange.hpp"
#include "actio/reduction/discrete_euler_poincare.hpp"
#include "actio/reduction/relative_motion.hpp"

using Attitude = actio::Element<actio::SO<3>, double>;
using Covector = actio::Momentum<actio::SO<3>, double>;

// [four_conditions]
// Each as a covector: how the action sum changes when the middle attitude is turned; the two terms of (3.2);
// how the reduced sum changes with the induced variations; the two terms of (3.10).
template <class Pair, class Reduced>
std::array<Covector, 4> four_conditions(Pair const& L, Reduced const& l, std::array<Attitude, 3> const& g) {
  auto const f01 = relative_motion_right(g[0], g[1]), f12 = relative_motion_right(g[1], g[2]);
  auto const action = [&](auto const& middle) {
    return discrete_action(L, std::array{like(middle, g[0]), middle, like(middle, g[2])});
  };
  auto const reduced_action = [&](auto const& k) {
    return l(like(k, f01) * inverse(k)) + l(k * like(k, f12));
  };
  return {right_differential(action, g[1]),                                             // (1)
          discrete_euler_lagrange(L, g[0], g[1], g[2]),                                 // (2)
          right_differential(reduced_action, actio::identity<double>(actio::SO<3>{})),  // (3)
          euler_poincare_right(l, f01, f12)};                                           // (4)
}
// [four_conditions]
