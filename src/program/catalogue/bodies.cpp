#include "program/catalogue/bodies.hpp"

#include "actio/bodies/body_catalogue.hpp"
#include "program/base/embedded.hpp"

namespace actio::scene {

std::vector<Body> const& library_bodies() {
  static std::vector<Body> const bodies = parse_bodies(embedded::bodies_toml, "bodies.toml");
  return bodies;
}

std::vector<std::string> names_of_bodies() {
  std::vector<std::string> names;
  for (auto const& body : library_bodies()) names.push_back(body.name);
  return names;
}

Body const* find_body(std::string const& name) {
  for (auto const& body : library_bodies())
    if (body.name == name) return &body;
  return nullptr;
}

}  // namespace actio::scene
