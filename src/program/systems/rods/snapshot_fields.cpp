#include "program/systems/rods/snapshot_fields.hpp"

#include <algorithm>

namespace actio::scene {

std::vector<std::string> RodField::columns() const {
  std::vector<std::string> out;
  for (auto const& one : components) out.push_back(named ? name + ("_" + one) : one);
  return out;
}

std::vector<RodField> const& fields_of_sections() {
  static std::vector<RodField> const all{
      {"position", "of the sections", "length", {"x", "y", "z"}, false},
      {"attitude",
       "unit quaternions, scalar first, from the axes of the sections to space",
       "1",
       {"qw", "qx", "qy", "qz"},
       false},
      {"velocity", "of the sections", "length/time", {"u", "v", "w"}, false},
      {"angular_velocity", "of the sections, in their axes", "1/time", {"w1", "w2", "w3"}, false}};
  return all;
}

std::vector<RodField> const& fields_of_elements() {
  static std::vector<std::string> const space{"x", "y", "z"}, section{"1", "2", "3"};
  static std::vector<RodField> const all{
      {"stretch", "Gamma less that at rest: stretch and the two shears", "1", section},
      {"curvature", "kappa less that at rest: twist and the two bends", "1/length", section},
      {"contact_force", "with which the rod beyond acts on that before, in space", "mass length/time^2",
       space},
      {"contact_moment", "the same about the middle of the element, in space", "mass length^2/time^2",
       space}};
  return all;
}

std::vector<RodField> rod_fields(std::vector<std::string> const& names) {
  std::vector<RodField> out;
  for (auto const& name : names)
    out.push_back(
        *std::ranges::find_if(fields_of_elements(), [&](RodField const& one) { return one.name == name; }));
  return out;
}

}  // namespace actio::scene
