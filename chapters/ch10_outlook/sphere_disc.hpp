// Fields on the sphere in colours: the sphere seen from afar, as a disc, or all of it in Mollweide's
// projection, which has equal areas; and the bar that says what a colour means.
#pragma once

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <vector>

#include "actio/sphere_fields/sphere_grid.hpp"
#include "book/png.hpp"
#include "book/program.hpp"
#include "book/svg.hpp"

namespace book {

/// From where a sphere is seen, in degrees.
struct SeenFrom {
  double longitude, latitude;
};

constexpr int colours = 255;
/// The number of the colour of a value: 127 is zero, 0 and 254 are -largest and largest.
inline unsigned char colour_number(double value, double largest) {
  return static_cast<unsigned char>(127 + std::lround(127 * std::clamp(value / largest, -1.0, 1.0)));
}
/// From blue below zero to red above; the root of the value makes weak parts visible.
inline std::vector<Colour> blue_and_red() {
  constexpr double blue[] = {24, 80, 150}, none[] = {244, 244, 240}, red[] = {176, 48, 24};
  std::vector<Colour> out;
  for (int i = -127; i <= 127; ++i) {
    double const part = std::pow(std::abs(i) / 127.0, 0.75);
    Colour colour;
    for (std::size_t k = 0; k < 3; ++k)
      colour[k] =
          static_cast<unsigned char>(std::lround(none[k] + part * ((i < 0 ? blue : red)[k] - none[k])));
    out.push_back(colour);
  }
  return out;
}
/// The colour of a value, for an element of a picture.
inline std::string colour_of(double value, double largest) {
  auto const c = blue_and_red()[colour_number(value, largest)];
  return "rgb(" + std::to_string(c[0]) + "," + std::to_string(c[1]) + "," + std::to_string(c[2]) + ")";
}

/// A field between the points of its grid: linear in both angles.
class FieldOnSphere {
 public:
  /// Of a grid with equal steps in both angles.
  FieldOnSphere(actio::sphere::SphereGrid const& grid, actio::sphere::GridField const& field)
      : grid_(grid), field_(field) {}

  /// At a colatitude and a longitude, in radians.
  double operator()(double theta, double phi) const {
    auto const between = [](double at, int last) {
      double const inside = std::clamp(at, 0.0, static_cast<double>(last));
      int const low = std::min(static_cast<int>(inside), std::max(last - 1, 0));
      return std::pair{low, inside - low};
    };
    auto const [row, down] = between(theta / M_PI * grid_.latitudes() - 0.5, grid_.latitudes() - 1);
    double const turns = phi / (2 * M_PI), place = (turns - std::floor(turns)) * grid_.longitudes;
    int const west = static_cast<int>(place) % grid_.longitudes, east = (west + 1) % grid_.longitudes;
    double const along = place - std::floor(place);
    auto const on = [&](int r) { return (1 - along) * field_(r, west) + along * field_(r, east); };
    return (1 - down) * on(row) + down * on(row + 1);
  }

 private:
  actio::sphere::SphereGrid const& grid_;
  actio::sphere::GridField const& field_;
};

/// An ellipse full of colours, with its rim: `value(u, v)` for u to the right and v upwards, both from -1
/// to 1.
template <class Value>
std::string coloured_ellipse(svg::Point at, double across, double up, double largest, Value const& value) {
  int const width = static_cast<int>(std::lround(2 * across)), height = static_cast<int>(std::lround(2 * up));
  std::vector<unsigned char> cells;
  for (int row = 0; row < height; ++row)
    for (int column = 0; column < width; ++column) {
      double u = 2 * (column + 0.5) / width - 1, v = 1 - 2 * (row + 0.5) / height;
      // What lies outside is cut away: there the colours of the rim go on.
      if (double const r = std::hypot(u, v); r > 0.999) u *= 0.999 / r, v *= 0.999 / r;
      cells.push_back(colour_number(value(u, v), largest));
    }
  auto const name = "rim" + svg::pixel(at.x) + "_" + svg::pixel(at.y);
  auto const ellipse = [&](std::string const& look) {
    return "<ellipse" + look + " cx=\"" + svg::pixel(at.x) + "\" cy=\"" + svg::pixel(at.y) + "\" rx=\"" +
           svg::pixel(across) + "\" ry=\"" + svg::pixel(up) + "\"/>";
  };
  return "<clipPath id=\"" + name + "\">" + ellipse("") + "</clipPath>\n<image clip-path=\"url(#" + name +
         ")\" x=\"" + svg::pixel(at.x - across) + "\" y=\"" + svg::pixel(at.y - up) + "\" width=\"" +
         svg::pixel(2 * across) + "\" height=\"" + svg::pixel(2 * up) +
         "\" preserveAspectRatio=\"none\" href=\"data:image/png;base64," +
         base64(png(width, height, cells, blue_and_red())) + "\"/>\n" + ellipse(" class=\"axis\"") + "\n";
}

/// Elements of a picture: the field as a disc.
/// @param at       the centre, in pixels
/// @param largest  the value of the strongest colour
inline std::string sphere_disc(svg::Point at, double radius, actio::sphere::SphereGrid const& grid,
                               actio::sphere::GridField const& field, double largest, SeenFrom eye) {
  double const longitude = eye.longitude * M_PI / 180, latitude = eye.latitude * M_PI / 180;
  FieldOnSphere const value(grid, field);
  return coloured_ellipse(at, radius, radius, largest, [&](double x, double y) {
    double const z = std::sqrt(std::max(0.0, 1 - x * x - y * y));
    double const up = y * std::cos(latitude) + z * std::sin(latitude),
                 out = z * std::cos(latitude) - y * std::sin(latitude);
    return value(std::acos(std::clamp(up, -1.0, 1.0)), longitude + std::atan2(x, out));
  });
}

/// Elements of a picture: all of the sphere in Mollweide's projection, the meridian 0 in the middle.
/// @param at  the centre  @param width  of the ellipse, which is half as high
inline std::string sphere_map(svg::Point at, double width, actio::sphere::SphereGrid const& grid,
                              actio::sphere::GridField const& field, double largest) {
  FieldOnSphere const value(grid, field);
  return coloured_ellipse(at, width / 2, width / 4, largest, [&](double u, double v) {
    double const t = std::asin(v), sine = (2 * t + std::sin(2 * t)) / M_PI;
    return value(std::acos(std::clamp(sine, -1.0, 1.0)), M_PI * u / std::cos(t));
  });
}

/// Elements of a picture: the colours from -largest to largest, with the numbers below.
/// @param at  the left upper corner
inline std::string colour_bar(svg::Point at, double width, double largest, std::string const& name) {
  std::vector<unsigned char> all;
  for (int i = 0; i < colours; ++i) all.push_back(static_cast<unsigned char>(i));
  std::string out = "<image x=\"" + svg::pixel(at.x) + "\" y=\"" + svg::pixel(at.y) + "\" width=\"" +
                    svg::pixel(width) + "\" height=\"9\" preserveAspectRatio=\"none\" " +
                    "href=\"data:image/png;base64," + base64(png(colours, 1, all, blue_and_red())) + "\"/>\n";
  for (int k = -1; k <= 1; ++k)
    out += svg::label({at.x + (k + 1) * width / 2, at.y + 24}, number(k * largest, 2), "middle");
  return out + svg::label({at.x + width / 2, at.y - 6}, name, "middle");
}

}  // namespace book
