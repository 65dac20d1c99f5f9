#include "actio/scene/body_shape.hpp"

#include <toml++/toml.h>

#include "actio/scene/embedded.hpp"
#include "actio/scene/systems/body_input.hpp"

namespace actio::scene {
namespace {

Eigen::Vector3d vector(toml::node_view<toml::node const> list) { return {list[0].value_or(0.0), list[1].value_or(0.0), list[2].value_or(0.0)}; }

/// Point masses as balls that do not touch, of volumes as their masses.
std::vector<BodyShape::Part> balls(std::vector<double> const& masses, std::vector<Eigen::Vector3d> const& places) {
  double nearest = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < places.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) nearest = std::min(nearest, (places[i] - places[j]).norm());
  double const largest = *std::max_element(masses.begin(), masses.end());
  std::vector<BodyShape::Part> out;
  for (std::size_t i = 0; i < places.size(); ++i) out.push_back({false, 0.45 * nearest * std::cbrt(masses[i] / largest), 0, places[i], Eigen::Vector3d::Zero()});
  return out;
}

/// The parts of a body of the catalogue, from their common centre of mass. The catalogue itself keeps their inertia alone.
std::vector<BodyShape::Part> parts_of(std::string const& name) {
  toml::table const catalogue = toml::parse(embedded::bodies_toml);
  auto const* const body = catalogue[name].as_table();
  if (!body) return {};
  std::vector<BodyShape::Part> parts;
  std::vector<double> masses;
  std::vector<Eigen::Vector3d> places;
  for (char const* const key : {"cylinders", "points"}) {
    auto const* const list = (*body)[key].as_array();
    for (std::size_t i = 0; list && i < list->size(); ++i) {
      toml::node_view<toml::node const> const part(list->get(i));
      masses.push_back(part["mass"].value_or(0.0)), places.push_back(vector(part["at"]));
      if (part["radius"]) parts.push_back({true, part["radius"].value_or(0.0), part["length"].value_or(0.0), places.back(), vector(part["along"]).stableNormalized()});
    }
  }
  if (places.empty()) return {};
  if (parts.empty()) parts = balls(masses, places);
  double mass = 0;
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();
  for (std::size_t i = 0; i < places.size(); ++i) mass += masses[i], centre += masses[i] * places[i];
  for (auto& part : parts) part.at -= centre / mass;
  return parts;
}

}  // namespace

std::optional<BodyShape> body_shape(Scene const& scene) {
  std::string const& kind = scene.system->name;
  SceneTable const system = scene.file.section("system");
  if (kind == "rigid_body") {
    GivenInertia const inertia = read_body_or_inertia(system);
    return BodyShape{inertia.principal.moments, inertia.axes, system.has("body") ? parts_of(system.text("body")) : std::vector<BodyShape::Part>{}, {}};
  }
  if (kind == "heavy_top") {
    GivenInertia const inertia = read_inertia(system);
    return BodyShape{inertia.principal.moments, inertia.axes, {}, BodyShape::Top{system.number("mass"), system.vector("centre_of_mass"), system.vector("gravity")}};
  }
  return std::nullopt;
}

}  // namespace actio::scene
