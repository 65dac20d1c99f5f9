// What can be told of a medium of a scene.
#pragma once

#include "program/medium_output/fields.hpp"
#include "program/registry/system.hpp"
#include "program/systems/media/loops.hpp"

namespace actio::scene {

/// The records of its quantities.
/// @param fluid  of a fluid the circulation is conserved
std::vector<Quantity> medium_quantities(bool fluid);

/// How they come from its motion.
/// @param loops  for the circulation; none where it is not asked for
template <int d>
void define_medium(QuantityGraph& graph, MediumView<d> const& medium,
                   std::vector<MaterialLoop<d>> const& loops, double step);

/// The records of the sums over a body alone: energy, momenta, circulation.
std::vector<Quantity> sums_of_body(bool fluid);
/// How these come from its motion.
/// \copydetails define_medium
template <int d>
void define_sums(QuantityGraph& graph, MediumView<d> const& medium,
                 std::vector<MaterialLoop<d>> const& loops);

}  // namespace actio::scene
