// The companions of a run with steps: the same motion with longer ones.
#pragma once

#include <functional>
#include <initializer_list>

#include "program/registry/simulation.hpp"

namespace actio::scene {

/// A companion, and a control with steps of twice its length, from which `ErrorEstimate` tells the error; by
/// the first of some multiples with which both can be made. With steps r times as long they cost 3/(2 r) of
/// the run.
/// @param make       the motion with steps so many times as long; throws Error where they are beyond the
///                   scheme
/// @param multiples  that are tried
/// @param order      of the method
/// @param attitude   whether it is reconstructed
Companion companions(std::function<std::unique_ptr<Motion>(long)> const& make,
                     std::initializer_list<long> multiples, int order, bool attitude);
/// Of a run that has no error but that of rounding.
/// @param how  it comes about: "exact: ..."
Companion no_error(std::string how, bool attitude);

}  // namespace actio::scene
