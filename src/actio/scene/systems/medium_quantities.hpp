// What can be told of a medium of a scene.
#pragma once

#include "actio/scene/system.hpp"
#include "actio/scene/systems/medium_fields.hpp"
#include "actio/scene/systems/medium_input.hpp"

namespace actio::scene {

/// The records of its quantities.
/// @param fluid  of a fluid the circulation is conserved
std::vector<Quantity> medium_quantities(bool fluid);

/// A closed row of nodes: the circulation is taken along it.
template <int d>
struct MaterialLoop {
  /// A node, and how far beyond its place the loop passes, in a periodic box; length.
  struct Stop {
    std::size_t node;                ///< which one
    std::array<double, d> beyond{};  ///< of its place
  };
  std::vector<Stop> stops;  ///< the last one is the first one, a period further or not
};
/// The outermost closed row of nodes of a body in the plane, counterclockwise; along a direction of a
/// periodic box the row that goes once around it. Empty where there is none.
template <int d>
MaterialLoop<d> outermost_loop(MediumCells<d> const& cells, MediumMesh const& mesh);

/// How they come from its motion.
template <int d>
void define_medium(QuantityGraph& graph, MediumView<d> const& medium, MaterialLoop<d> const& loop,
                   double step);

}  // namespace actio::scene
