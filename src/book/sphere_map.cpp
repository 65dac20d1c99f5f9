#include "book/sphere_map.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "book/axis.hpp"
#include "book/plot.hpp"

namespace book {
namespace {

constexpr double pi = std::numbers::pi, degree = pi / 180;

/// The cubic through four values that passes the middle two with the slopes of their neighbours.
double between(double a, double b, double c, double d, double s) {
  return b + 0.5 * s * (c - a + s * (2 * a - 5 * b + 4 * c - d + s * (3 * (b - c) + d - a)));
}

struct OnSphere {
  double theta, phi;
};
/// Where a point of a disc of radius 1 is on the sphere; none beyond the rim.
std::optional<OnSphere> seen(double x, double y, SeenFrom eye) {
  double const square = x * x + y * y;
  if (square > 1) return {};
  double const z = std::sqrt(1 - square), s = std::sin(eye.latitude * degree),
               c = std::cos(eye.latitude * degree);
  return OnSphere{std::acos(std::clamp(y * c + z * s, -1.0, 1.0)),
                  eye.longitude * degree + std::atan2(x, z * c - y * s)};
}
/// The same of an ellipse with the half axes 2 and 1: the projection of Mollweide.
std::optional<OnSphere> mollweide(double x, double y, double longitude) {
  if (std::abs(y) > 1 || std::abs(x) > 2 * std::sqrt(1 - y * y)) return {};
  double const a = std::asin(y), c = std::sqrt(std::max(1e-300, 1 - y * y));
  return OnSphere{pi / 2 - std::asin(std::clamp((2 * a + std::sin(2 * a)) / pi, -1.0, 1.0)),
                  longitude * degree + pi * x / (2 * c)};
}
/// And back, from a latitude and a longitude from the middle.
svg::Point in_mollweide(double latitude, double from_middle) {
  double a = latitude;
  for (int k = 0; k < 60 && std::abs(latitude) < 1.5707; ++k)
    a -= (2 * a + std::sin(2 * a) - pi * std::sin(latitude)) / (2 + 2 * std::cos(2 * a));
  return {2 * from_middle / pi * std::cos(a), std::sin(a)};
}

std::string image(svg::Point corner, double width, double height, std::string const& bytes) {
  return "<image x=\"" + svg::pixel(corner.x) + "\" y=\"" + svg::pixel(corner.y) + "\" width=\"" +
         svg::pixel(width) + "\" height=\"" + svg::pixel(height) +
         "\" preserveAspectRatio=\"none\" href=\"data:image/png;base64," + base64(bytes) + "\"/>\n";
}
/// A picture of the points that a projection finds on the sphere; the others are not painted.
template <class Projection>
std::string painted(svg::Point centre, double width, double height, SphereField const& field, double largest,
                    Projection const& projection) {
  int const columns = static_cast<int>(std::lround(2 * width)),
            rows = static_cast<int>(std::lround(2 * height));
  double const scale = largest > 0 ? 127 / largest : 0;
  std::vector<unsigned char> cells;
  for (int i = 0; i < rows; ++i)
    for (int j = 0; j < columns; ++j) {
      auto const at = projection((2.0 * j + 1) / columns - 1, 1 - (2.0 * i + 1) / rows);
      cells.push_back(static_cast<unsigned char>(
          at ? 127 + std::lround(std::clamp(scale * field(at->theta, at->phi), -127.0, 127.0)) : 255));
    }
  return image({centre.x - width / 2, centre.y - height / 2}, width, height,
               png(columns, rows, cells, signed_colours()));
}

/// A line in pieces, broken where a point is not seen.
template <class Place>
std::string line(int pieces, Place const& place) {
  std::string out;
  bool on = false;
  for (int k = 0; k <= pieces; ++k) {
    std::optional<svg::Point> const p = place(double(k) / pieces);
    if (p) out += (on ? "L" : "M") + svg::pixel(p->x) + " " + svg::pixel(p->y);
    on = p.has_value();
  }
  return out;
}
/// Parallels and meridians, 30 degrees apart, and the rim.
template <class Place>
std::string net(Place const& place, std::string const& rim) {
  std::string d;
  for (int latitude = -60; latitude <= 60; latitude += 30)
    d += line(90, [&](double s) { return place(latitude * degree, (2 * s - 1) * pi); });
  for (int longitude = -180; longitude <= 180; longitude += 30)
    d += line(60, [&](double s) { return place((s - 0.5) * pi, longitude * degree); });
  return "<path d=\"" + d +
         "\" fill=\"none\" stroke=\"#22272d\" stroke-opacity=\".16\" stroke-width=\".7\"/>\n" + rim;
}

}  // namespace

double SphereField::value(int row, int column) const {
  // Beyond a pole one goes down on the other side.
  if (row < 0 || row >= rows_) row = row < 0 ? -1 - row : 2 * rows_ - 1 - row, column += columns_ / 2;
  column = (column % columns_ + columns_) % columns_;
  return values_[static_cast<std::size_t>(row * columns_ + column)];
}

double SphereField::operator()(double theta, double phi) const {
  double const down = theta / pi * rows_ - 0.5, right = phi / (2 * pi) * columns_;
  int const i = static_cast<int>(std::floor(down)), j = static_cast<int>(std::floor(right));
  double rows[4];
  for (int k = 0; k < 4; ++k)
    rows[k] = between(value(i + k - 1, j - 1), value(i + k - 1, j), value(i + k - 1, j + 1),
                      value(i + k - 1, j + 2), right - j);
  return between(rows[0], rows[1], rows[2], rows[3], down - i);
}

std::vector<Colour> signed_colours() {
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

std::string globe(svg::Point centre, double radius, SphereField const& field, double largest, SeenFrom eye) {
  auto const place = [&](double latitude, double longitude) -> std::optional<svg::Point> {
    double const s = std::sin(eye.latitude * degree), c = std::cos(eye.latitude * degree);
    double const x = std::cos(latitude) * std::sin(longitude), out = std::cos(latitude) * std::cos(longitude),
                 up = std::sin(latitude);
    if (out * c + up * s < 0) return {};
    return svg::Point{centre.x + radius * x, centre.y - radius * (up * c - out * s)};
  };
  return painted(centre, 2 * radius, 2 * radius, field, largest,
                 [&](double x, double y) { return seen(x, y, eye); }) +
         net(place, "<circle cx=\"" + svg::pixel(centre.x) + "\" cy=\"" + svg::pixel(centre.y) + "\" r=\"" +
                        svg::pixel(radius) + "\" fill=\"none\" stroke=\"#5c6670\" stroke-width=\"1.4\"/>\n");
}

std::string whole_sphere(svg::Point centre, double width, SphereField const& field, double largest,
                         double longitude) {
  auto const place = [&](double latitude, double from_middle) -> std::optional<svg::Point> {
    auto const p = in_mollweide(latitude, from_middle);
    return svg::Point{centre.x + width / 4 * p.x, centre.y - width / 4 * p.y};
  };
  return painted(centre, width, width / 2, field, largest,
                 [&](double x, double y) { return mollweide(2 * x, y, longitude); }) +
         net(place, "<ellipse cx=\"" + svg::pixel(centre.x) + "\" cy=\"" + svg::pixel(centre.y) + "\" rx=\"" +
                        svg::pixel(width / 2) + "\" ry=\"" + svg::pixel(width / 4) +
                        "\" fill=\"none\" stroke=\"#5c6670\" stroke-width=\"1.4\"/>\n");
}

std::string flat_map(svg::Point at, double side, std::vector<double> const& values, double largest) {
  int const points = static_cast<int>(std::lround(2 * side)),
            n = static_cast<int>(std::lround(std::sqrt(static_cast<double>(values.size()))));
  double const scale = largest > 0 ? 127 / largest : 0;
  auto const row = [&](int k, int j, double s) {
    auto const value = [&](int l) {
      return values[static_cast<std::size_t>((k + n) % n * n + (j + l + n) % n)];
    };
    return between(value(-1), value(0), value(1), value(2), s);
  };
  std::vector<unsigned char> cells;
  for (int i = 0; i < points; ++i)
    for (int j = 0; j < points; ++j) {
      double const x = (j + 0.5) / points * n, y = (1 - (i + 0.5) / points) * n;
      int const k = static_cast<int>(x), l = static_cast<int>(y);
      double const value =
          between(row(l - 1, k, x - k), row(l, k, x - k), row(l + 1, k, x - k), row(l + 2, k, x - k), y - l);
      cells.push_back(
          static_cast<unsigned char>(127 + std::lround(std::clamp(scale * value, -127.0, 127.0))));
    }
  return image(at, side, side, png(points, points, cells, signed_colours())) + "<rect x=\"" +
         svg::pixel(at.x) + "\" y=\"" + svg::pixel(at.y) + "\" width=\"" + svg::pixel(side) + "\" height=\"" +
         svg::pixel(side) + "\" fill=\"none\" stroke=\"#5c6670\" stroke-width=\"1.4\"/>\n";
}

std::string colour_bar(svg::Point at, double width, double largest, std::string const& name) {
  std::vector<unsigned char> cells;
  for (int i = 0; i < 255; ++i) cells.push_back(static_cast<unsigned char>(i));
  return image(at, width, 10, png(255, 1, cells, signed_colours())) +
         svg::label({at.x, at.y + 24}, number(-largest, 3), "middle") +
         svg::label({at.x + width / 2, at.y + 24}, name, "middle") +
         svg::label({at.x + width, at.y + 24}, number(largest, 3), "middle");
}

}  // namespace book
