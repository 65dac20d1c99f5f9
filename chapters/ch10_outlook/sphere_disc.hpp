// A field on the sphere as a coloured disc: the sphere seen from afar.
#pragma once

#include <Eigen/Core>

#include "actio/sphere_fields/sphere_grid.hpp"
#include "book/svg.hpp"

namespace book {

/// From where a sphere is seen, in degrees.
struct SeenFrom {
  double longitude, latitude;
};

/// The colour of a value: blue below zero, red above, in steps of the largest.
inline std::string colour_of(double value, double largest) {
  double const part = std::round(8 * std::clamp(value / largest, -1.0, 1.0)) / 8,
               size = std::sqrt(std::abs(part));
  auto const mix = [&](double full) { return static_cast<int>(std::lround(244 + (full - 244) * size)); };
  auto const text = part < 0 ? "rgb(" + std::to_string(mix(24)) + "," + std::to_string(mix(80)) + "," +
                                   std::to_string(mix(150)) + ")"
                             : "rgb(" + std::to_string(mix(176)) + "," + std::to_string(mix(48)) + "," +
                                   std::to_string(mix(24)) + ")";
  return text;
}

/// Elements of a picture: the field as a disc, row by row, neighbours of one colour together.
/// @param at       the centre, in pixels
/// @param largest  the value of the strongest colour
inline std::string sphere_disc(svg::Point at, double radius, actio::sphere::SphereGrid const& grid,
                               actio::sphere::GridField const& field, double largest, SeenFrom eye) {
  double const longitude = eye.longitude * M_PI / 180, latitude = eye.latitude * M_PI / 180;
  auto const value = [&](double x, double y) {
    double const z = std::sqrt(std::max(0.0, 1 - x * x - y * y));
    double const up = y * std::cos(latitude) + z * std::sin(latitude),
                 out = z * std::cos(latitude) - y * std::sin(latitude);
    double const theta = std::acos(std::clamp(up, -1.0, 1.0)), phi = longitude + std::atan2(x, out);
    Eigen::Index row = 0;
    (grid.colatitude - theta).abs().minCoeff(&row);
    int const count = grid.longitudes;
    int const column = static_cast<int>(std::lround(phi / (2 * M_PI) * count)) % count;
    return field(row, (column + count) % count);
  };
  double const pixel = 3;
  // Rows reach beyond the outline, and are cut there: 48.3 per cent of their box, for radii of about 100.
  double const beyond = 3;
  std::string out = "<g style=\"clip-path:circle(48.3%)\">\n";
  for (double y = -radius; y < radius; y += pixel) {
    double const middle = -(y + pixel / 2) / radius;
    if (std::abs(middle) >= 1) continue;
    double const half = std::sqrt(1 - middle * middle) * radius;
    std::string last;
    double begun = 0;
    auto const draw = [&](double end) {
      if (last.empty() || end - begun < 0.05) return;
      out += "<rect x=\"" + svg::pixel(at.x + begun) + "\" y=\"" + svg::pixel(at.y + y) + "\" width=\"" +
             svg::pixel(end - begun) + "\" height=\"3.2\" fill=\"" + last + "\"/>\n";
    };
    for (double x = -half; x < half; x += pixel) {
      auto const colour =
          colour_of(value(std::min(x + pixel / 2, half) / radius * 0.999, middle * 0.999), largest);
      if (colour == last) continue;
      draw(x);
      begun = last.empty() ? -half - beyond : x, last = colour;
    }
    draw(half + beyond);
  }
  return out + "</g>\n";
}

}  // namespace book
