// STATEMENT(id, title) { ... }: the check of one statement of the thesis.
//
// The body is compiled once for the scalar of its unit (ACTIO_SCALAR: double, dec50, dec100 or rational) as a function template over S, with `claim` (claim.hpp)
// and `draw` (random points, draw.hpp) at hand; `if constexpr (Real<S>)` leaves out what needs a root. It gives a verdict, evidence and a control.
//
// A source all of whose statements are identities that the rationals decide exactly says so in its head, `// Scalars: rational, double`: it is compiled for
// these alone. Without such a line it is compiled for all four.
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "claim.hpp"

namespace actio::checks {

/// The scalar of this unit.
using CheckScalar = ACTIO_SCALAR;

/// A check that has been compiled into this program.
struct Check {
  char const *id, *title, *scalar, *source;
  Record (*run)(Check const&, std::uint64_t seed);
};
/// All checks of this program, in the order of their registration.
std::vector<Check>& all_checks();  // main.cpp

template <class S, void (*body)(Claim<S>&, Draw&)>
Record run_check(Check const& check, std::uint64_t seed) {
  Claim<S> claim(check.id, check.title, check.scalar, seed);
  body(claim, claim.draw);
  claim.judge_controls();
  return std::move(claim.record);
}

bool add_check(Check const& check);  // main.cpp

}  // namespace actio::checks

#define STATEMENT(id, title)                                                                                                      \
  template <class S>                                                                                                               \
  static void id(actio::checks::Claim<S>& claim, actio::Draw& draw);                                                               \
  static bool const registered_##id = actio::checks::add_check(                                                                    \
      {#id, title, ACTIO_SCALAR_NAME, __FILE__, &actio::checks::run_check<actio::checks::CheckScalar, id<actio::checks::CheckScalar>>}); \
  template <class S>                                                                                                               \
  static void id([[maybe_unused]] actio::checks::Claim<S>& claim, [[maybe_unused]] actio::Draw& draw)
