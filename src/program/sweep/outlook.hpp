// The plan of a sweep, what it would do: for `actio sweep --dry-run`.
#pragma once

#include <string>
#include <vector>

#include "program/sweep/member.hpp"

namespace actio::scene {

/// Members, keys and values, rows and bytes, and which members are refused.
/// @param results  of reading all scenes
std::string sweep_outlook(SweepPlan const& plan, std::vector<MemberResult> const& results);

}  // namespace actio::scene
