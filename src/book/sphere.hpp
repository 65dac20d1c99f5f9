// Curves on a sphere, seen from afar: what lies behind is dashed and pale.
//
//   auto sphere = book::Sphere(30, 20).axes({"1", "2", "3"}); // seen from 30 degrees east, 20 degrees north
//   sphere.curve(exact).dots(momenta, "every step"); program.picture("polhode", sphere.svg(), "...");
//
// Points are brought to the unit sphere, so that momenta of any unit may be given as they are.
#pragma once

#include <array>

#include "book/program.hpp"
#include "book/svg.hpp"

namespace book {

/// Curves on the unit sphere in orthographic projection; every function returns the sphere, so that calls can
/// be joined.
class Sphere {
 public:
  /// A point or direction in space.
  using Vector = std::array<double, 3>;

  /// @param azimuth    where the eye is, in degrees from the first axis towards the second
  /// @param elevation  in degrees from the plane of the first two axes towards the third
  explicit Sphere(double azimuth = 35, double elevation = 22);

  /// Shows the three axes with their names.
  Sphere& axes(std::array<std::string, 3> names) { return names_ = std::move(names), *this; }

  /// Adds a curve through the points, each a vector with three components (`p[0]`, `p[1]`, `p[2]`).
  template <class Points>
  Sphere& curve(Points const& points, std::string label = "", Look look = {}) {
    if (look.colour == 0) look.colour = static_cast<int>(curves_.size()) % 6 + 1;
    Curve added{{}, std::move(label), look};
    for (auto const& p : points) {
      double const length = std::hypot(p[0], p[1], p[2]);
      added.points.push_back({p[0] / length, p[1] / length, p[2] / length});
    }
    curves_.push_back(std::move(added));
    return *this;
  }
  /// Adds points without a line through them.
  template <class Points>
  Sphere& dots(Points const& points, std::string label = "", Look look = {}) {
    look.dots = true;
    return curve(points, std::move(label), look);
  }

  /// The picture.
  std::string svg() const;

 private:
  struct Curve {
    std::vector<Vector> points;
    std::string label;
    Look look;
  };
  static constexpr double centre = 220, radius = 170;

  static double dot(Vector const& a, Vector const& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
  double depth(Vector const& p) const { return dot(p, eye_); }
  svg::Point place(Vector const& p) const {
    return {centre + radius * dot(p, right_), centre - radius * dot(p, up_)};
  }

  /// Draws a curve in pieces: those behind the sphere, dashed, and those before it.
  void add(Curve const& c, std::string& behind, std::string& before) const;

  /// Where the way from a to b passes the outline.
  Vector crossing(Vector const& a, Vector const& b) const;

  /// Circles of latitude and meridians, every thirty degrees.
  void add_graticule(std::string& behind, std::string& before) const;

  /// The part of each positive axis that stands out of the sphere.
  std::string axis_arrows() const;

  Vector right_{}, up_{}, eye_{};
  std::array<std::string, 3> names_;
  std::vector<Curve> curves_;
};

}  // namespace book
