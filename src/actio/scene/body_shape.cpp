#include "actio/scene/body_shape.hpp"

#include "actio/scene/bodies.hpp"
#include "actio/scene/systems/body_input.hpp"

namespace actio::scene {
namespace {

BodyShape::Part ball(PointMass const& point, double radius) { return {false, radius, 0, point.at, Eigen::Vector3d::Zero()}; }
BodyShape::Part cylinder(Cylinder const& c) { return {true, c.radius, c.length, c.at, c.along.stableNormalized()}; }

/// Point masses as balls that do not touch, of volumes as their masses.
std::vector<BodyShape::Part> balls(std::vector<PointMass> const& points) {
  double nearest = std::numeric_limits<double>::infinity(), largest = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) nearest = std::min(nearest, (points[i].at - points[j].at).norm());
    largest = std::max(largest, points[i].mass);
  }
  std::vector<BodyShape::Part> out;
  for (auto const& point : points) out.push_back(ball(point, 0.45 * nearest * std::cbrt(point.mass / largest)));
  return out;
}

/// What the body is made of, as far as the catalogue says it.
std::vector<BodyShape::Part> parts_of(Body const& body) {
  std::vector<BodyShape::Part> parts = balls(body.points);
  for (auto const& c : body.cylinders) parts.push_back(cylinder(c));
  return parts;
}

}  // namespace

std::optional<BodyShape> body_shape(Scene const& scene) {
  std::string const& kind = scene.system->name;
  SceneTable const system = scene.file.section("system");
  if (kind == "rigid_body") {
    PrincipalInertia const inertia = read_body_or_inertia(system);
    return BodyShape{inertia.inertia.moments, inertia.axes, system.has("body") ? parts_of(*find_body(system.text("body"))) : std::vector<BodyShape::Part>{}, {}};
  }
  if (kind == "heavy_top") {
    PrincipalInertia const inertia = read_inertia(system);
    return BodyShape{inertia.inertia.moments, inertia.axes, {}, BodyShape::Top{system.number("mass"), system.vector("centre_of_mass"), system.vector("gravity")}};
  }
  return std::nullopt;
}

}  // namespace actio::scene
