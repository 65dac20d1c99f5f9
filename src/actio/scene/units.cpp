#include "actio/scene/units.hpp"

#include <algorithm>

#include "actio/scene/bodies.hpp"

namespace actio::scene {
namespace {

void replace(std::string& text, std::string const& what, std::string const& by) {
  for (std::size_t at = 0; (at = text.find(what, at)) != std::string::npos; at += by.size()) text.replace(at, what.size(), by);
}

}  // namespace

std::string words(std::string name) {
  std::ranges::replace(name, '_', ' ');
  return name;
}

std::string time_unit(Scene const& scene) {
  SceneTable const system = scene.file.section("system");
  if (!system.has("body") || !system.is_text("body")) return "";
  LibraryBody const* const body = find_body(system.text("body"));
  return body ? body->time : "";
}

std::string unit_of(Scene const& scene, Quantity const& quantity) {
  std::string unit = quantity.unit;
  if (auto const time = time_unit(scene); !time.empty()) replace(unit, "time", time);
  replace(unit, " x ", " × ");
  replace(unit, "^2k", "²ᵏ");
  replace(unit, "^2", "²");
  return unit;
}

}  // namespace actio::scene
