// What a scene of a medium has that ends the conservation of something.
#pragma once

#include <set>

#include "program/registry/conservation.hpp"
#include "program/systems/media/loads.hpp"
#include "program/systems/media/loops.hpp"
#include "program/systems/media/material.hpp"

namespace actio::scene {

/// Of sides, loads, method and density, but for what depends on the start and on loops.
template <int d>
std::set<Feature> features_of(SceneFile const& file, MediumMesh const& mesh, MediumLoads<d> const& loads,
                              Material const& material, bool uniform);

/// Of the loops along which the circulation is taken.
/// @param x  places of the nodes at the start
template <int d>
std::set<Feature> features_of_loops(MediumMesh const& mesh, MediumCells<d> const& cells,
                                    MediumLoads<d> const& loads, std::vector<MaterialLoop<d>> const& loops,
                                    std::vector<std::array<double, d>> const& x);

}  // namespace actio::scene
