// Shapes of bodies from files in the format .obj: lines `v x y z` for vertices and `f a b c ...` for faces.
#pragma once

#include <string>
#include <string_view>

#include "actio/two_bodies/polyhedron.hpp"

namespace actio::bodies {

/// A file of a shape that cannot be read.
struct ShapeError : Error {
  using Error::Error;
};

/// The surface that a text in the format .obj describes. Faces with more than three vertices are cut into
/// triangles from the first; normals, textures and groups are passed over.
/// @param length_unit  what a length of 1 in the text is, m
/// @throws ShapeError     where a line has no meaning, with its number
/// @throws OutsideDomain  where the unit is not positive
Polyhedron<double> parse_obj(std::string_view text, double length_unit = 1);
/// The same from a file.
/// @throws ShapeError  where it cannot be read
Polyhedron<double> read_obj(std::string const& path, double length_unit = 1);

}  // namespace actio::bodies
