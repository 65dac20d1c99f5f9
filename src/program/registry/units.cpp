#include "program/registry/units.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>

#include "program/catalogue/bodies.hpp"
#include "program/registry/common_keys.hpp"

namespace actio::scene {
namespace {

void replace(std::string& text, std::string const& what, std::string const& by) {
  for (std::size_t at = 0; (at = text.find(what, at)) != std::string::npos; at += by.size())
    text.replace(at, what.size(), by);
}

/// Moments and time say what an energy is measured in.
Units with_energy(std::string time, std::string moment) {
  std::string const energy = moment.empty() || time.empty()      ? ""
                             : moment == "kg m^2" && time == "s" ? "J"
                                                                 : moment + "/" + time + "^2";
  return {std::move(time), std::move(moment), energy, "", ""};
}

/// A name that stands in axes of pictures and in attributes of files as it is.
std::string unit_named(SceneFile const& file, Key<std::string> const& key) {
  if (!key.given(file)) return "";
  std::string const name = key.read(file);
  bool const plain = std::all_of(name.begin(), name.end(),
                                 [](unsigned char c) { return c >= 0x80 || std::isalpha(c) || c == '_'; });
  if (name.empty() || name.size() > 16 || !plain || printable(name) != name)
    key.fail(file, "the name of a unit is expected, of at most 16 letters, for example \"m\"; found '" +
                       shown(name, 40) + "'");
  return name;
}

}  // namespace

std::string Units::in(std::string unit) const {
  if (!energy.empty()) {
    std::string const momentum = moment + "/" + time;
    replace(unit, "energy x time", momentum);
    replace(unit, "energy", energy);
  }
  if (!mass.empty() && !length.empty()) replace(unit, "mass x length", mass + " " + length);
  if (!mass.empty()) replace(unit, "mass", mass);
  if (!length.empty()) replace(unit, "length", length);
  // What is left of time stands for itself, as in 1/time.
  if (!time.empty()) replace(unit, "time", time);
  return unit;
}

Units units_of(Body const& body) { return with_energy(body.time, body.unit); }

Units read_units(SceneFile const& file) {
  SceneTable const system = file.section("system"), scene = file.section("scene");
  Body const* const body =
      system.has("body") && system.is_text("body") ? find_body(system.text("body")) : nullptr;
  if (!scene.has("units")) return body ? units_of(*body) : Units{};
  if (body)
    scene.fail("units",
               fmt::format("units: {} has its own, {} and {}; a scene with a body of the library names none",
                           body->name, body->time, body->unit));
  std::string const mass = unit_named(file, unit_keys.mass), length = unit_named(file, unit_keys.length);
  Units out = with_energy(unit_named(file, unit_keys.time),
                          mass.empty() || length.empty() ? "" : mass + " " + length + "^2");
  out.mass = mass, out.length = length;
  return out;
}

std::string words(std::string name) {
  std::ranges::replace(name, '_', ' ');
  return name;
}

std::string time_unit(Scene const& scene) { return read_units(scene.file).time; }

std::string plain_unit_of(Scene const& scene, Quantity const& quantity) {
  return read_units(scene.file).in(quantity.unit);
}

std::string unit_of(Scene const& scene, Quantity const& quantity) {
  std::string unit = plain_unit_of(scene, quantity);
  replace(unit, " x ", " × ");
  replace(unit, "^2k", "²ᵏ");
  replace(unit, "^2", "²");
  return unit;
}

}  // namespace actio::scene
