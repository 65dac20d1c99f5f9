// Fields on the sphere in colours: a globe, seen from afar, and the whole sphere in the projection of
// Mollweide, which keeps areas; and a field on a flat torus. All are drawn with two points of the picture for
// each pixel of a screen.
#pragma once

#include <string>
#include <vector>

#include "book/png.hpp"
#include "book/svg.hpp"

namespace book {

/// From where a sphere is seen, in degrees.
struct SeenFrom {
  double longitude;  ///< of the middle of what is seen
  double latitude;   ///< north positive
};

/// A field on the sphere between its values on a grid: cubic in both angles, across the poles as well.
class SphereField {
 public:
  /// @param values  row by row from the north, the row i at the colatitude (i + 1/2) pi/rows, and in each the
  ///                column j at the longitude 2 pi j/columns; the number of columns is even
  SphereField(int rows, int columns, std::vector<double> values)
      : rows_(rows), columns_(columns), values_(std::move(values)) {}

  /// At a colatitude, from 0 to pi, and a longitude, in radians.
  double operator()(double theta, double phi) const;

 private:
  double value(int row, int column) const;
  int rows_, columns_;
  std::vector<double> values_;
};

/// Colours from blue for the most negative over nearly white to red: 255 of them, the middle one for zero.
std::vector<Colour> signed_colours();

/// Elements of a picture: the half of the sphere that is seen, as a disc with its parallels and meridians.
/// @param centre   in pixels
/// @param largest  the value of the strongest colour
std::string globe(svg::Point centre, double radius, SphereField const& field, double largest, SeenFrom eye);
/// The whole sphere as an ellipse that is twice as wide as it is high.
/// @param longitude  of the middle, in degrees
std::string whole_sphere(svg::Point centre, double width, SphereField const& field, double largest,
                         double longitude = 180);
/// Another surface in the same colours: a square that is periodic in both directions, with a frame.
/// @param at      the upper left corner
/// @param values  as many rows as columns: row by row from the least y, which is below, and in each from the
///                least x; after the last of them the first follows again
std::string flat_map(svg::Point at, double side, std::vector<double> const& values, double largest);
/// What the colours mean: a bar with its ends and a name below it, 34 pixels high in all.
/// @param at  the upper left corner
std::string colour_bar(svg::Point at, double width, double largest, std::string const& name);

}  // namespace book
