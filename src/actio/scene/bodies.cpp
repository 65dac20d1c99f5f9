#include "actio/scene/bodies.hpp"

#include "actio/rigid_body/body_catalogue.hpp"
#include "actio/scene/embedded.hpp"

namespace actio::scene {

std::vector<LibraryBody> const& library_bodies() {
  static std::vector<LibraryBody> const bodies = [] {
    std::vector<LibraryBody> out;
    for (auto const& b : parse_bodies(embedded::bodies_toml, "bodies.toml"))
      out.push_back({b.name, b.title, b.source, b.derived, b.time, b.ratio ? "ratio" : "kg m^2", b.inertia, b.axes, b.axes * b.spin.coordinates});
    return out;
  }();
  return bodies;
}

std::vector<std::string> names_of_bodies() {
  std::vector<std::string> names;
  for (auto const& body : library_bodies()) names.push_back(body.name);
  return names;
}

LibraryBody const* find_body(std::string const& name) {
  for (auto const& body : library_bodies())
    if (body.name == name) return &body;
  return nullptr;
}

}  // namespace actio::scene
