// Files of Gmsh: all versions, in digits and in bytes; what is refused, and where; files that are damaged.
#include <boost/test/unit_test.hpp>

#include "gmsh_samples.hpp"
#include "refused.hpp"
#include "witness/draw.hpp"

using namespace actio;
using namespace actio::media;
using namespace actio::testing::gmsh;

BOOST_AUTO_TEST_CASE(all_forms_give_the_same_mesh_of_every_shape) {
  struct Expected {
    Sample sample;
    char const *shape, *side;
    std::size_t nodes, facets;
    double volume;
  };
  for (auto const& expected :
       {Expected{triangles(), "triangle", "bottom", 4, 1, 1},
        Expected{quadrangles(), "quadrilateral", "1", 6, 1, 2},
        Expected{tetrahedra(), "tetrahedron", "floor", 5, 1, 0.5},
        Expected{hexahedron(), "hexahedron", "8", 8, 1, 2}, Expected{segments(), "segment", "5", 3, 1, 3}}) {
    auto const first = gmsh_mesh_of(Writer(true, false).write(expected.sample), "sample");
    BOOST_TEST(name_of(first.shape) == std::string(expected.shape));
    BOOST_TEST(first.nodes.size() == expected.nodes);
    BOOST_TEST(first.sides.at(expected.side).size() == expected.facets);
    BOOST_TEST(std::abs(volume_of(first) - expected.volume) < 1e-15);
    for (auto const& [version, binary, old] : {std::tuple(true, true, false),
                                               {false, false, false},
                                               {false, true, false},
                                               {true, false, true},
                                               {true, true, true}}) {
      auto const other = gmsh_mesh_of(Writer(version, binary, old).write(expected.sample), "sample");
      BOOST_TEST((other.nodes == first.nodes));
      BOOST_TEST((other.cells == first.cells));
      BOOST_TEST((other.sides == first.sides));
    }
  }
  // A side takes the order of its cell, whatever that of the file: outwards.
  auto const square = gmsh_mesh_of(Writer(false, false).write(triangles()), "sample");
  BOOST_TEST((square.sides.at("4") == std::vector<std::array<int, 4>>{{3, 0, -1, -1}, {2, 3, -1, -1}}));
}

BOOST_AUTO_TEST_CASE(a_section_that_is_not_known_is_passed_whatever_it_holds) {
  for (bool const new_version : {true, false})
    for (bool const binary : {true, false}) {
      auto sample = triangles();
      sample.names += "$Comments\nall of $Nodes\n$Nodes\n$EndComments\n$Other\n$EndOther\n";
      auto const mesh = gmsh_mesh_of(Writer(new_version, binary).write(sample), "sample");
      BOOST_TEST(mesh.nodes.size() == 4u);
      BOOST_TEST(mesh.cells.size() == 2u);
    }
  not_read("$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Comments\n$Nodes\n", "$Comments has no end");
}

// What is left of a third coordinate is measured by the size of the mesh, whatever its unit.
BOOST_AUTO_TEST_CASE(a_plane_mesh_may_have_the_rounding_of_its_size_across_the_plane) {
  for (double const size : {1e-9, 1.0, 1e9}) {
    auto sample = triangles();
    for (auto& node : sample.nodes)
      for (double& x : node) x *= size;
    sample.nodes[3][2] = 32 * std::numeric_limits<double>::epsilon() * size;
    BOOST_TEST(gmsh_mesh_of(Writer(true, true).write(sample), "sample").nodes[2][2] == 0);
    // A thousand times as much is a place outside of the plane.
    sample.nodes[3][2] *= 1000;
    not_read(Writer(true, true).write(sample), "is not in the plane");
  }
}

BOOST_AUTO_TEST_CASE(what_is_wrong_in_a_text_is_named_with_its_line) {
  auto const text = Writer(false, false).write(triangles());
  not_read(text.substr(0, text.find("$Elements")), "the file has no section $Elements");
  not_read(replaced(text, "2.2", "3"), "line 2: version 3 of the format is not read");
  not_read("$NOD\n", "line 1: version 1 of the format is not read; save as 4.1 or 2.2");
  not_read(replaced(text, "50 0 1 0", "50 0 1"), "line 16: a coordinate of a node should be a number");
  not_read(replaced(text, "50 0 1 0", "50 0 nan 0"), "line 15: a coordinate of a node is no finite number");
  not_read(replaced(text, "50 0 1 0", "40 0 1 0"), "line 15: node 40 comes twice");
  not_read(replaced(text, "50 0 1 0", "50 0 1 3"), "line 15: node 50 at (0, 1, 3) is not in the plane");
  not_read(replaced(text, "20 40 50", "20 40 70"),
           "line 24: a triangle has node 70, which the file does not have");
  // By the tags of the file, in the versions of digits and of bytes.
  not_read(replaced(text, "20 40 50", "20 40 20"), "element 51 with nodes 20 40 20");
  not_read(replaced(text, "20 40 50", "20 40 20"), "a cell is not degenerate");
  not_read(replaced(text, "1 2 2 9 1 20 40 50", "1 9 2 9 1 20 40 50"), "elements of type 9 (of second or");
  not_read(replaced(text, "1 2 2 9 1 20 40 50", "1 3 2 9 1 20 30 40 50"), "cells are of one kind");
  not_read(replaced(text, "$Nodes\n5", "$Nodes\n500000000000"), "500000000000 nodes are announced");
  not_read(replaced(text, "$EndNodes", "$EndNode"), "$EndNodes is needed, and '$EndNode' is found");
  not_read(replaced(text, "\"bottom\"", "bottom"), "a name in quotation marks is needed");
  not_read("", "line 1: the file ends where $MeshFormat should be");
  // Two triangles that meet at a node alone.
  auto sample = triangles();
  sample.nodes[0] = {1, 2, 0}, sample.parts[3].elements[1] = {3, 0, 4};
  sample.parts.erase(sample.parts.begin() + 1, sample.parts.begin() + 3);
  for (bool const version : {false, true})
    for (bool const binary : {false, true})
      not_read(Writer(version, binary).write(sample),
               "element 21 with nodes 40 10 50 is unconnected to element 11");
  auto const bytes = Writer(true, true).write(hexahedron());
  not_read(replaced(bytes, std::string("\1\0\0\0", 4), std::string("\0\0\0\1", 4)),
           "byte 20: the number one");
  not_read(bytes.substr(0, 400), "byte 278: 8 nodes are announced, and the file has room for 3");
  not_read(replaced(text, "$Nodes", "$PartitionedEntities\n$EndPartitionedEntities\n$Nodes"),
           "only meshes in one part are read");
  CHECK_REFUSED(gmsh_mesh("/no/such/file.msh"), Error);
  CHECK_REFUSED(gmsh_mesh("/"), Error);
}

BOOST_AUTO_TEST_CASE(a_damaged_file_is_refused_or_is_another_mesh_of_a_body) {
  Draw draw(5);
  auto const below = [&](std::size_t n) { return std::size_t(draw.below(n)); };
  int refusals = 0, count = 0;
  for (auto const& sample : {triangles(), quadrangles(), tetrahedra(), hexahedron(), segments()})
    for (int form = 0; form < 4; ++form)
      for (int k = 0; k < 25; ++k, ++count) {
        auto text = Writer(form & 1, form & 2).write(sample);
        for (std::size_t times = 1 + below(3); times > 0 && !text.empty(); --times) switch (below(4)) {
            case 0:
              text[below(text.size())] = char(below(256));
              break;
            case 1:
              text.resize(below(text.size()));
              break;
            case 2:
              text.erase(below(text.size()), below(20));
              break;
            default:
              text.insert(below(text.size()), text.substr(below(text.size()), below(20)));
          }
        try {
          require_body_mesh(gmsh_mesh_of(text, "damaged"));
        } catch (NotAGmshFile const&) {
          ++refusals;
        } catch (NotABodyMesh const&) {
          ++refusals;
        }
      }
  BOOST_TEST(count == 500);
  // Where only a coordinate or an unused tag changes there is still a mesh.
  BOOST_TEST(refusals > 400);
  BOOST_TEST(refusals < 500);
}
