// How fast a system with a Lagrangian of one's own moves at its start: what the default step goes by.
#pragma once

#include "program/systems/lagrangians/input.hpp"

namespace actio::scene {

/// The largest of some rates, 1/time: of turning, of what the equations of motion linearized at the start
/// have as eigenvalues, and the root of how fast the turning grows. Zero where nothing changes.
/// @param time  over which the motion is looked at, at most
double fastest_rate(ReducedScene const& scene, double time);

}  // namespace actio::scene
