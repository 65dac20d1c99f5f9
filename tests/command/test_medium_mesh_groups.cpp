// Groups of a mesh that lie inside of a body: left where nobody names them, used where a scene does.
#include <cmath>

#include "medium_scene.hpp"

namespace {

using namespace command;

/// Nine unit squares; the group "ring" is the edge of the one in the middle, counterclockwise or clockwise,
/// "low" is the side below, and "stray" the diagonal of a square.
std::string nine_squares(bool clockwise = false) {
  auto const node = [](int i, int j) { return std::to_string(1 + i + 4 * j) + " "; };
  std::string nodes, elements;
  int count = 0;
  for (int j = 0; j < 4; ++j)
    for (int i = 0; i < 4; ++i) nodes += node(i, j) + std::to_string(i) + " " + std::to_string(j) + " 0\n";
  auto const line = [&](int group, std::string const& from, std::string const& to) {
    elements += std::to_string(++count) + " 1 2 " + std::to_string(group) + " 1 " + from + to + "\n";
  };
  int const ring[][2] = {{1, 1}, {2, 1}, {2, 2}, {1, 2}, {1, 1}};
  for (int k = 0; k < 4; ++k) {
    auto const from = node(ring[k][0], ring[k][1]), to = node(ring[k + 1][0], ring[k + 1][1]);
    clockwise ? line(1, to, from) : line(1, from, to);
  }
  for (int i = 0; i < 3; ++i) line(2, node(i, 0), node(i + 1, 0));
  line(3, node(0, 0), node(1, 1));
  for (int j = 0; j < 3; ++j)
    for (int i = 0; i < 3; ++i)
      elements += std::to_string(++count) + " 3 2 4 1 " + node(i, j) + node(i + 1, j) + node(i + 1, j + 1) +
                  node(i, j + 1) + "\n";
  return "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$PhysicalNames\n3\n1 1 \"ring\"\n1 2 \"low\"\n1 3 \"stray\"\n"
         "$EndPhysicalNames\n$Nodes\n16\n" +
         nodes + "$EndNodes\n$Elements\n" + std::to_string(count) + "\n" + elements + "$EndElements\n";
}
Medium body(std::string const& system) {
  Medium out;
  out.kind = "elastic_body", out.material = "name = \"neo_hookean\", mu = 1, kappa = 3";
  out.mesh = "file = \"squares.msh\"", out.system = system;
  out.quantities = "\"momentum\"", out.until = "0.1";
  return out;
}
Table run_on(std::string const& mesh, Medium const& scene) {
  Folder const folder;
  folder.write("squares.msh", mesh);
  return run_in(folder, scene);
}
void check_refused(Medium const& scene, std::string const& says) {
  Folder const folder;
  folder.write("squares.msh", nine_squares());
  auto const outcome = actio({"run", folder.write("medium.toml", scene.text()), "--dry-run"});
  BOOST_TEST(outcome.status == 2, says);
  BOOST_TEST(outcome.err.find(says) != std::string::npos, outcome.err);
}

}  // namespace

BOOST_AUTO_TEST_SUITE(medium_mesh_groups)

BOOST_AUTO_TEST_CASE(a_group_inside_is_held_where_the_scene_says_so_and_not_otherwise) {
  // Nine squares of density 1 fall for a tenth of a unit of time.
  auto const fallen = [](std::string const& boundary) {
    return run_on(nine_squares(), body("load = { gravity = \"10*y\" }\n" + boundary))["momentum_y"].back();
  };
  BOOST_TEST(std::abs(fallen("") + 9) <= 1e-12);
  BOOST_TEST(std::abs(fallen("boundary = { ring = \"free\" }") + 9) <= 1e-12);
  // Four of sixteen nodes, with the mass 4 of nine, stay where they are.
  double const held = fallen("boundary = { ring = \"fixed\" }");
  BOOST_TEST(held > -5);
  BOOST_TEST(held < -3);
}

BOOST_AUTO_TEST_CASE(a_loop_along_a_group_inside_goes_the_way_of_the_file) {
  for (bool const clockwise : {false, true}) {
    auto scene = body("loops = { inner = \"ring\" }");
    scene.quantities = "\"circulation\"", scene.initial = "velocity = [\"-Y/2\", \"X/2\"]";
    auto const rows = run_on(nine_squares(clockwise), scene);
    BOOST_TEST(std::abs(rows.rows[0][1] - (clockwise ? -1 : 1)) <= 1e-14);
  }
}

BOOST_AUTO_TEST_CASE(what_a_group_cannot_do_is_refused_where_the_scene_asks_for_it) {
  check_refused(body("load = { pressure = { ring = 0.1 } }"),
                "a pressure acts on a side of the body, and the group 'ring' of the mesh lies inside");
  check_refused(body("boundary = { stray = \"fixed\" }"),
                "the group 'stray' of the mesh is no side of the body: the line 8 of it belongs to no cell");
  check_refused(body("boundary = { rang = \"fixed\" }"), "the body has no side 'rang'");
}

BOOST_AUTO_TEST_SUITE_END()
