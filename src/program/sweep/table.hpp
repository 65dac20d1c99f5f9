// The table of a sweep: a row for each member.
//
//     member,method.step,status,steps,wall_seconds,drift_energy,error_momentum,last_t,last_energy,message
//     0,0.1,0,100,0.0012,3.1e-16,2.5e-06,10,0.25,
//
// Columns are those of all members, in the order in which they first come; a member that lacks one, or
// failed, has an empty cell there. The last one tells what went wrong.
#pragma once

#include "program/sweep/member.hpp"

namespace actio::scene {

/// The table, in comma-separated values; numbers with 17 significant digits, texts between quotes where they
/// need them.
/// @param results  in the order of the members
std::string sweep_table(SweepPlan const& plan, std::vector<MemberResult> const& results);

}  // namespace actio::scene
