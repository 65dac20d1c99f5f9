// A body that attracts another, as a scene says it: [system.primary] or [system.secondary].
#pragma once

#include <Eigen/Core>

#include "actio/two_bodies/extended_body.hpp"
#include "program/document/key.hpp"

namespace actio::scene {

/// A body and its density, zero where that is not told.
struct GivenBody {
  bodies::ExtendedBody body;  ///< with its moments
  double density;             ///< mass/length^3
};

/// The records of one table.
/// @param name   "system.primary"
/// @param which  "first body"
std::vector<Parameter> mass_parameters(std::string const& name, std::string const& which);
/// Whether the moments of the body are known to order 2 and no further.
bool is_of_order_two(SceneTable const& table);
/// Reads it.
/// @param order  of the moments
/// @throws SceneError  where a value is missing or wrong, or no body has such moments
GivenBody read_mass(SceneTable const& table, int order, std::vector<std::string>& remarks);

}  // namespace actio::scene
