// Many pairs of bodies stepped side by side: each a lane of SIMD registers.
//
//     std::vector<TwoBodies> pairs = ...;        // of any bodies and starts
//     step_side_by_side(pairs, 1000);            // as pair.step(1000) for each of them
//
// The step is that of TwoBodies, the same lines of code over \ref actio::Pack instead of double.
#pragma once

#include <span>
#include <vector>

#include "actio/two_bodies/two_bodies.hpp"

namespace actio::bodies {

/// So many steps of each pair, as TwoBodies::step, to rounding.
///
/// Pairs that follow each other in the list and have the same options move together: up to eight with
/// AVX-512, up to four with AVX2. The order must be 2, or 4 with bodies that are symmetric about three
/// planes, as ellipsoids are; rotors must be exact, without a third body and tides. All others move one by
/// one. Where a rotor turns too far for the series of short_step.hpp, or an orbit passes near the centre, the
/// pack takes that drift lane by lane.
/// @return  the indices of the pairs that could not move, for which `pairs[k].step(count)` throws and says
///          why. They are as they were before
/// @throws OutsideDomain  where the count is negative
std::vector<std::size_t> step_side_by_side(std::span<TwoBodies> pairs, long count);

/// TwoBodies::lyapunov_exponent of each pair, side by side in the same way; no number where the motion has
/// none. The pairs stay where they are.
/// @throws OutsideDomain  where a number is not positive, or there are tides
std::vector<double> lyapunov_exponents(std::span<TwoBodies const> pairs, long count, long every = 16);

}  // namespace actio::bodies
