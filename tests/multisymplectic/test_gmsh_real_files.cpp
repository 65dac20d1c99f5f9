// Files of Gmsh as they occur: what they may have that says nothing of the body, cells that are numbered
// either way or listed twice, groups inside, meshes that are folded.
#include <boost/test/unit_test.hpp>

#include "gmsh_samples.hpp"

using namespace actio;
using namespace actio::media;
using namespace actio::testing::gmsh;

BOOST_AUTO_TEST_SUITE(gmsh_real_files)

// Forms that other programs write, and older versions of Gmsh.
BOOST_AUTO_TEST_CASE(what_says_nothing_of_the_body_changes_nothing) {
  auto const text = Writer(false, false).write(triangles());
  auto const mesh = gmsh_mesh_of(text, "sample");
  auto const same = [&](std::string const& other) {
    auto const read = gmsh_mesh_of(other, "sample");
    BOOST_TEST((read.nodes == mesh.nodes));
    BOOST_TEST((read.cells == mesh.cells));
    BOOST_TEST((read.sides == mesh.sides));
  };
  for (char const* version : {"2", "2.0", "2.1"}) same(replaced(text, "2.2", version));
  same(replaced(text, "\"bottom\"", "\"bottom\" some_kind"));
  same(replaced(text, "1 3 \"bottom\"", "1 3\"bottom\""));
  same("$Comments\n$MeshFormat\n$EndComments\n" + text);
  same(replaced(text, "$Nodes", "$Periodic\n1\n0 1 2\n1\n20 50\n$EndPeriodic\n$Nodes"));
  same(replaced(text, "50 0 1 0", "+50 1e-330 +1.0 -1e-400"));
  same(
      replaced(replaced(replaced(text, "$Nodes\n", "$ParametricNodes\n"), "$EndNodes", "$EndParametricNodes"),
               "10 5 5 0 \n20 0 0 0 \n30 1 0 0 \n40 1 1 0 \n50 0 1 0 \n",
               "10 5 5 0 0 1\n20 0 0 0 1 2 0.5\n30 1 0 0 2 1 0.5 7\n40 1 1 0 3 1\n50 0 1 0 0 9\n"));
  auto lifted = triangles();
  for (auto& node : lifted.nodes) node[2] = 3.1;
  same(Writer(false, false).write(lifted));
  // In version 2.0 names had no dimension; of a name with one nothing else is known there.
  same(replaced(replaced(replaced(text, "2.2", "2"), "1 3 \"bottom\"", "3 \"bottom\""), "2 9 \"the",
                "9 \"the"));
  not_read(replaced(text, "50 0 1 0", "50 0 1e400 0"), "line 15: a coordinate of a node is no finite number");
  not_read(replaced(text, "50 0 1 0", "50 0 +-1 0"), "line 15: a coordinate of a node should be a number");
}

BOOST_AUTO_TEST_CASE(cells_that_are_numbered_the_other_way_round_are_the_same_body) {
  for (auto sample : {triangles(), quadrangles(), tetrahedra(), hexahedron(), segments()}) {
    auto const first = gmsh_mesh_of(Writer(true, false).write(sample), "sample");
    // All of them, and one of two.
    for (std::size_t from : {std::size_t(0), std::size_t(1)}) {
      auto turned = sample;
      for (auto& part : turned.parts)
        if (part.dimension == first.dimension)
          for (std::size_t k = from; k < part.elements.size(); ++k) {
            auto& nodes = part.elements[k];
            if (nodes.size() == 8)
              std::swap_ranges(nodes.begin(), nodes.begin() + 4, nodes.begin() + 4);
            else
              std::reverse(nodes.begin(), nodes.end());
            if (nodes.size() == 4 && part.type == 4)
              std::swap(nodes[0], nodes[1]), std::swap(nodes[1], nodes[2]);
          }
      auto const other = gmsh_mesh_of(Writer(true, false).write(turned), "sample");
      require_body_mesh(other);
      BOOST_TEST(std::abs(volume_of(other) - volume_of(first)) < 1e-15);
      BOOST_TEST(other.sides.size() == first.sides.size());
      for (auto const& [name, facets] : first.sides) {
        BOOST_TEST(other.sides.at(name).size() == facets.size());
        // It looks outwards all the same: in the plane with the body at its left.
        if (first.shape == CellShape::triangle) BOOST_TEST((other.sides.at(name) == facets));
      }
    }
  }
}

BOOST_AUTO_TEST_CASE(an_element_that_is_listed_for_each_of_its_groups_is_one_cell) {
  for (auto const& sample : {triangles(), quadrangles(), tetrahedra(), hexahedron(), segments()}) {
    auto const first = gmsh_mesh_of(Writer(false, false).write(sample), "sample");
    auto twice = sample;
    for (auto const& part : sample.parts) {
      twice.parts.push_back(part);
      twice.parts.back().group = 77;
      // Of a group with a minus Gmsh turns the elements round.
      if (part.type == 2 || part.type == 3)
        for (auto& nodes : twice.parts.back().elements) std::reverse(nodes.begin(), nodes.end());
    }
    for (bool const binary : {false, true}) {
      auto const mesh = gmsh_mesh_of(Writer(false, binary).write(twice), "sample");
      BOOST_TEST((mesh.cells == first.cells));
      BOOST_TEST((mesh.element_tags == first.element_tags));
      for (auto const& [name, facets] : first.sides) BOOST_TEST((mesh.sides.at(name) == facets));
      // And all facets of these sides are in the other group as well.
      std::size_t facets = 0;
      for (auto const& side : first.sides) facets += side.second.size();
      BOOST_TEST(mesh.sides.at("77").size() == facets);
    }
  }
}

BOOST_AUTO_TEST_CASE(groups_inside_of_a_body_are_no_sides_and_wait_for_who_names_them) {
  auto const text = Writer(false, false).write(triangles());
  // The diagonal, in the direction of the file, whichever cell comes first.
  for (bool const back : {false, true}) {
    auto const mesh = gmsh_mesh_of(
        replaced(text, "1 1 2 3 1 20 30", back ? "1 1 2 3 1 40 20" : "1 1 2 3 1 20 40"), "sample");
    BOOST_TEST(!mesh.sides.contains("bottom"));
    std::array<int, 4> const diagonal = back ? std::array{2, 0, -1, -1} : std::array{0, 2, -1, -1};
    BOOST_TEST((mesh.inside.at("bottom") == std::vector{diagonal}));
    BOOST_TEST(mesh.no_sides.empty());
    BOOST_TEST(mesh.sides.at("4").size() == 2);
  }
  // A part of a side inside: then all of it waits.
  auto const part = gmsh_mesh_of(replaced(text, "21 1 2 4 1 50 40", "21 1 2 4 1 20 40"), "sample");
  BOOST_TEST(part.inside.at("4").size() == 2);
  BOOST_TEST(!part.sides.contains("4"));
  // The other diagonal is no edge of a cell.
  auto const none = gmsh_mesh_of(replaced(text, "1 1 2 3 1 20 30", "1 1 2 3 1 30 50"), "sample");
  BOOST_TEST(none.no_sides.at("bottom") == "the line 11 of it belongs to no cell");
  BOOST_TEST(!none.sides.contains("bottom"));
}

BOOST_AUTO_TEST_CASE(a_mesh_that_is_folded_is_refused_with_the_place) {
  auto const text = Writer(false, false).write(triangles());
  // The corner (0, 1) drawn over the diagonal, to (0.7, 0.2).
  not_read(replaced(text, "50 0 1 0", "50 0.7 0.2 0"),
           "element 51 with nodes 20 50 40 lies over element 41: the mesh is folded along the facet 20 40");
  auto solid = tetrahedra();
  solid.nodes[4] = {0.1, 0.1, 0.1};
  not_read(Writer(true, true).write(solid),
           "lies over element 11: the mesh is folded along the facet 20 30 40");
  auto line = segments();
  line.nodes[2] = {0.5, 0, 0};
  not_read(Writer(true, false).write(line), "the mesh is folded along the facet 20");
  auto sheet = quadrangles();
  sheet.nodes[2] = {0.2, 0, 0}, sheet.nodes[3] = {0.2, 1, 0};
  not_read(Writer(true, false).write(sheet), "the mesh is folded along the facet 20 50");
}

BOOST_AUTO_TEST_SUITE_END()
