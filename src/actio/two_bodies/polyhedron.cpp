#include "actio/two_bodies/polyhedron.hpp"

#include <map>

namespace actio::bodies {

void require_closed(std::vector<std::array<int, 3>> const& faces, int vertices) {
  std::map<std::pair<int, int>, std::array<int, 2>> edges;  // how often there, and how often back
  for (auto const& face : faces)
    for (int k = 0; k < 3; ++k) {
      int const from = face[k], to = face[(k + 1) % 3];
      if (from < 0 || from >= vertices)
        throw OutsideDomain("polyhedron", "a triangle names a vertex that is not there; number of the vertex",
                            from, vertices - 1);
      ++edges[std::minmax(from, to)][from < to ? 0 : 1];
    }
  for (auto const& [edge, met] : edges)
    for (int way : {0, 1})
      if (met[way] != 1)
        throw OutsideDomain(
            "polyhedron",
            "each edge must be met by two triangles, once in each direction; number of triangles with "
            "the edge from vertex " +
                std::to_string(way == 0 ? edge.first : edge.second) + " to vertex " +
                std::to_string(way == 0 ? edge.second : edge.first),
            met[way], 1);
}

}  // namespace actio::bodies
