// The shapes of a rod of a scene: at rest, [system.rod], and at the start, [initial].
#pragma once

#include "actio/rods/rod_shape.hpp"
#include "program/document/key.hpp"
#include "program/systems/shared_names.hpp"

namespace actio::scene {

/// A shape with the arc length of its sections.
struct SceneRodShape {
  rods::RodShape shape;           ///< the sections
  std::vector<double> distances;  ///< of the sections from the start along the rod at rest, length
  double length;                  ///< of the rod at rest
};

/// The shape at rest; defaults are written back.
/// @param remarks  on elements that turn by more than 60 degrees
/// @throws SceneError  where a value is missing or wrong, or an element turns by more than a right angle
SceneRodShape read_rest_shape(SceneFile const& file, SharedNames& shared, std::vector<std::string>& remarks);
/// That at the start: the one at rest where [initial] says nothing else.
/// @throws SceneError  likewise
rods::RodShape read_start_shape(SceneFile const& file, SceneRodShape const& rest, SharedNames& shared,
                                std::vector<std::string>& remarks);

/// Whether a rod has the constraint.
bool read_unshearable(SceneFile const& file);
/// The records of the keys of [system.rod] but for the section, and of those of [initial] for the shape.
std::vector<Parameter> rod_shape_parameters();

}  // namespace actio::scene
