// What a complaint about a step adds of the times of rows.
#pragma once

#include "program/document/schedule.hpp"

namespace actio::scene {

/// The longest step of those that rows allow, or where that is much shorter how they need not, in words to be
/// added to a complaint.
std::string step_that_meets(Schedule const& schedule, double longest);

}  // namespace actio::scene
