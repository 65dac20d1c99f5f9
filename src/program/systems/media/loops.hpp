// Material loops of a medium of a scene: closed rows of nodes, along which its circulation is taken.
#pragma once

#include "program/medium_output/motion.hpp"
#include "program/systems/media/input.hpp"

namespace actio::scene {

/// A closed row of nodes: the circulation is taken along it.
template <int d>
struct MaterialLoop {
  /// A node, and how far beyond its place the loop passes, in a periodic box; length.
  struct Stop {
    std::size_t node;                ///< which one
    std::array<double, d> beyond{};  ///< of its place
  };
  std::string name;         ///< in [system.loops]; empty of the outermost one where that is left out
  std::vector<Stop> stops;  ///< the last one is the first one, a period further or not
};

/// The names in [system.loops]; empty where it is left out.
std::vector<std::string> loop_names(SceneFile const& file);

/// That loops which are named are looked at: the circulation is asked for.
/// @throws SceneError  at the first one, where it is not
void require_used_loops(SceneFile const& file, bool circulates);

/// The loops of [system.loops]. Left out it is the outermost closed row of nodes of a body in the plane,
/// counterclockwise, or the row that goes once around a periodic box.
/// @throws SceneError  where one is not closed, or the body has none
template <int d>
std::vector<MaterialLoop<d>> read_loops(SceneFile const& file, MediumCells<d> const& cells,
                                        MediumMesh const& mesh);

}  // namespace actio::scene
