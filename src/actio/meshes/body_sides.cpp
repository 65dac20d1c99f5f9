#include "actio/meshes/body_sides.hpp"

namespace actio::media {

void require_side(BodyMesh const& mesh, std::string const& name) {
  if (mesh.sides.contains(name)) return;
  std::vector<std::string> known;
  for (auto const& [other, facets] : mesh.sides) known.push_back(other);
  throw UnknownSide("sides of a body: there is no side '" + name + "'" + did_you_mean(name, known) +
                    "; the mesh has " + (known.empty() ? std::string("none") : listed(known)));
}

}  // namespace actio::media
