// A field on the sphere as a coloured disc: the sphere seen from afar.
#pragma once

#include <vector>

#include "actio/sphere_fields/sphere_grid.hpp"
#include "book/sphere_map.hpp"

namespace book {

/// Elements of a picture: a field on a grid of equal angles as a disc.
/// @param at       the centre, in pixels
/// @param largest  the value of the strongest colour
inline std::string sphere_disc(svg::Point at, double radius, actio::sphere::SphereGrid const& grid,
                               actio::sphere::GridField const& field, double largest, SeenFrom eye) {
  return globe(at, radius, {grid.latitudes(), grid.longitudes, {field.data(), field.data() + field.size()}},
               largest, eye);
}

}  // namespace book
