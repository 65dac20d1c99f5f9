// Maps of the snapshots of a run on a sphere: the whole sphere in the projection of Mollweide, with the north
// above and the longitude pi in the middle; and for the page of a run, values on a grid of equal angles.
#pragma once

#include <string>

#include "program/registry/scene.hpp"

namespace actio::scene {

/// The map of some snapshots of the run in a folder, from the first to the last that is there, as a picture
/// of the width of the others; empty where it has none on a sphere.
/// @throws FileError, SceneError  where the coefficients of one cannot be read
std::string vorticity_map(Scene const& scene, std::string const& folder, double width);
/// Maps of all of them, or of a hundred, as the page of the run has them: in JSON their times and their
/// values as pictures in shades of grey, the largest modulus, and how many snapshots there are.
/// `null` where there are fewer than two.
/// @throws FileError, SceneError  as above
std::string vorticity_maps_json(Scene const& scene, std::string const& folder);

}  // namespace actio::scene
