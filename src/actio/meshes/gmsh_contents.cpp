#include "actio/meshes/gmsh_contents.hpp"

namespace actio::media {

GmshShape const& gmsh_shape(GmshCursor const& file, int type) {
  static constexpr GmshShape known[] = {{15, 0, 1, "point"},      {1, 1, 2, "line"},
                                        {2, 2, 3, "triangle"},    {3, 2, 4, "quadrangle"},
                                        {4, 3, 4, "tetrahedron"}, {5, 3, 8, "hexahedron"}};
  for (auto const& shape : known)
    if (shape.type == type) return shape;
  std::string const what = type == 6                  ? " (a prism)"
                           : type == 7                ? " (a pyramid)"
                           : type == 34 || type == 35 ? " (a polygon or a polyhedron)"
                           : type >= 8 ? " (of second or higher order: ask Gmsh for Mesh.ElementOrder = 1)"
                                       : "";
  file.fail("elements of type " + std::to_string(type) + what +
            " are unknown here; known are point (15), line (1), triangle (2), quadrangle (3), "
            "tetrahedron (4) and hexahedron (5)");
}

}  // namespace actio::media
