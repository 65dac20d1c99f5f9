// A field on a grid of the sphere in colours: as a disc, or all of it in Mollweide's projection.
#pragma once

#include <algorithm>
#include <cmath>

#include "actio/sphere_fields/sphere_grid.hpp"
#include "book/sphere_map.hpp"

namespace book {

/// A field on a grid of equal angles, between its points.
inline SphereField on_sphere(actio::sphere::SphereGrid const& grid, actio::sphere::GridField const& field) {
  return {grid.latitudes(), grid.longitudes, {field.data(), field.data() + field.size()}};
}

/// Elements of a picture: the half of the sphere that is seen.
/// @param at       the centre, in pixels
/// @param largest  the value of the strongest colour
inline std::string sphere_disc(svg::Point at, double radius, actio::sphere::SphereGrid const& grid,
                               actio::sphere::GridField const& field, double largest, SeenFrom eye) {
  return globe(at, radius, on_sphere(grid, field), largest, eye);
}

/// The colour of a value, for an element of a picture.
inline std::string colour_of(double value, double largest) {
  static std::vector<Colour> const colours = signed_colours();
  auto const k = static_cast<std::size_t>(127 + std::lround(127 * std::clamp(value / largest, -1.0, 1.0)));
  auto const& c = colours[k];
  return "rgb(" + std::to_string(c[0]) + "," + std::to_string(c[1]) + "," + std::to_string(c[2]) + ")";
}

}  // namespace book
