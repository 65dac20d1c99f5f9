// What the two systems of media have in common (thesis, chapters 6 to 10): the multisymplectic scheme, its
// keys, and a motion made from a scene.
#pragma once

#include "actio/parallel/parts_on_ranks.hpp"
#include "program/registry/system.hpp"

namespace actio::scene {

/// A system of media, by its name, title, meaning and example: a fluid, or an elastic body. Its motion is
/// made by fused steps where the box of a scene allows them, else on a mesh.
System medium_system(bool fluid, std::string name, std::string title, std::string meaning,
                     std::string example);

/// The part of the medium of a scene on this rank, which is not the first.
/// @param scene  as a text, of which rank 0 has made a motion with steps of this length
std::unique_ptr<RankPart> part_of_medium(std::string const& scene, double step);

}  // namespace actio::scene
