#include <Eigen/Core>

#include "program/catalogue/body_shape.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace actio::scene {
namespace {

BodyShape::Part ball(PointMass const& point, double radius) {
  return {false, radius, 0, point.at, Eigen::Vector3d::Zero()};
}
BodyShape::Part cylinder(Cylinder const& c) {
  return {true, c.radius, c.length, c.at, c.along.stableNormalized()};
}

/// Point masses as balls that do not touch, of volumes as their masses.
std::vector<BodyShape::Part> balls(std::vector<PointMass> const& points) {
  double nearest = std::numeric_limits<double>::infinity(), largest = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) nearest = std::min(nearest, (points[i].at - points[j].at).norm());
    largest = std::max(largest, points[i].mass);
  }
  std::vector<BodyShape::Part> out;
  for (auto const& point : points)
    out.push_back(ball(point, 0.45 * nearest * std::cbrt(point.mass / largest)));
  return out;
}

}  // namespace

std::vector<BodyShape::Part> parts_of(Body const& body) {
  std::vector<BodyShape::Part> parts = balls(body.points);
  for (auto const& c : body.cylinders) parts.push_back(cylinder(c));
  return parts;
}

}  // namespace actio::scene
