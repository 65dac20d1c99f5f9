// Files of Gmsh at the edge of what is read: counts that just fit, tags at the ends of their range, and what
// is refused at which byte and line.
#include <boost/test/unit_test.hpp>

#include "actio/meshes/gmsh_mesh.hpp"
#include "caught.hpp"

using namespace actio;
using namespace actio::media;

namespace {
/// The unit square of two triangles in version 4.1: a curve of the group 7 below, and a surface.
std::string const square =
    "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n$PhysicalNames\n1\n1 7 \"bottom\"\n$EndPhysicalNames\n"
    "$Entities\n1 1 1 0\n1 0 0 0 0\n3 0 0 0 1 0 0 2 7 8 1 -1\n2 0 0 0 1 1 0 0 0\n$EndEntities\n$Nodes\n"
    "1 4 1 9\n2 2 0 4\n1\n3\n5\n9\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n$EndNodes\n$Elements\n2 3 1 3\n1 3 1 1\n"
    "1 1 3\n2 2 2 2\n2 1 3 5\n3 1 5 9\n$EndElements\n";
std::string with(std::string const& what, std::string const& by, std::string text = square) {
  auto const at = text.find(what);
  BOOST_REQUIRE(at != text.npos);
  return text.replace(at, what.size(), by);
}
/// Refused with these words, at the line on which the text has what is wrong.
void refused(std::string const& text, std::string const& words, std::string const& at_line_of) {
  std::size_t const at = at_line_of.empty() ? 0 : text.find(at_line_of);
  BOOST_REQUIRE(at != text.npos);
  std::size_t const line = 1 + std::size_t(std::count(text.begin(), text.begin() + long(at), '\n'));
  auto const e = testing::caught<NotAGmshFile>([&] { gmsh_mesh_of(text, "sample"); });
  BOOST_TEST(std::string(e.what()).find(words) != std::string::npos, e.what());
  if (at_line_of.empty()) return;
  BOOST_TEST(e.line == line, e.what());
  BOOST_TEST(std::string(e.what()).find("sample, line " + std::to_string(line) + ":") == 0, e.what());
  BOOST_TEST(std::size_t(std::count(text.begin(), text.begin() + long(e.byte), '\n')) + 1 == line);
}
}  // namespace

BOOST_AUTO_TEST_SUITE(gmsh_refusals)

BOOST_AUTO_TEST_CASE(a_file_is_read_as_its_text_is) {
  auto const path = std::filesystem::temp_directory_path() / "actio_gmsh_refusals.msh";
  std::ofstream(path, std::ios::binary) << square;
  auto const read = gmsh_mesh(path.string()), mesh = gmsh_mesh_of(square, "sample");
  std::filesystem::remove(path);
  BOOST_TEST((read.nodes == mesh.nodes && read.cells == mesh.cells && read.sides == mesh.sides));
  BOOST_TEST((mesh.nodes == std::vector<std::array<double, 3>>{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}));
  BOOST_TEST((mesh.node_tags == std::vector<int>{1, 3, 5, 9}));
  BOOST_TEST((mesh.element_tags == std::vector<std::size_t>{2, 3}));
  // The curve is in two groups, one of which has a name.
  BOOST_TEST(mesh.sides.size() == 2);
  for (char const* name : {"bottom", "8"})
    BOOST_TEST((mesh.sides.at(name) == std::vector<std::array<int, 4>>{{0, 1, -1, -1}}));
  // The same facet twice in the file is one of the side; an orientation of a group is no other group.
  auto const twice = with("2 3 1 3\n1 3 1 1\n1 1 3\n", "2 4 1 4\n1 3 1 2\n1 1 3\n8 3 1\n",
                          with("2 7 8 1 -1", "2 7 -8 1 -1"));
  BOOST_TEST((gmsh_mesh_of(twice, "sample").sides == mesh.sides));
}

BOOST_AUTO_TEST_CASE(what_does_not_fit_in_a_text_is_refused_at_its_line) {
  refused(with("$MeshFormat", "$Meshformat"), "$MeshFormat is needed, and '$Meshformat' is found", "$Mesh");
  refused(with("4.1 0 8", "4.1 2 8"), "text is 0 and bytes are 1, not 2", "4.1 2 8");
  refused(with("4.1 0 8", "4.1 1 4"), "numbers of 8 bytes are read, not of 4", "4.1 1 4");
  BOOST_TEST(gmsh_mesh_of(with("4.1 0 8", "4.1 0 4"), "").cells.size() == 2);
  refused(with("4.1 0 8", "4.2 0 8"), "version 4.2 of the format is not read", "4.2 0 8");
  refused(with("$Nodes", "Nodes"), "a section begins with $", "Nodes");
  refused(with("\"bottom\"", "\"bottom\n\""), "a name is not closed by a quotation mark", "1 7 \"bottom");
  refused(with("1 4 1 9\n2 2 0 4", "1 4 1 9\n4 2 0 4"), "an entity has 0 to 3 dimensions", "4 2 0 4");
  refused(with("1 4 1 9\n2 2 0 4", "1 4 1 9\n-1 2 0 4"), "an entity has 0 to 3 dimensions", "-1 2 0 4");
  refused(with("1 4 1 9", "1 3 1 9"), "blocks have more nodes than are announced", "2 2 0 4");
  refused(with("1 4 1 9", "1 5 1 9"), "blocks have fewer nodes than are announced", "0 1 0\n$EndNodes");
  refused(with("2 3 1 3", "2 2 1 3"), "blocks have more elements than are announced", "2 2 2 2");
  refused(with("2 3 1 3", "2 4 1 3"), "blocks have fewer elements than are announced", "3 1 5 9");
  refused(with("2 2 2 2\n", "1 2 2 2\n"), "triangles do not lie on an entity of dimension 1", "1 2 2 2\n");
  refused(with("2 2 2 2\n", "2 2 6 2\n"), "elements of type 6 (a prism) are unknown", "2 2 6 2");
  refused(with("2 2 2 2\n", "2 2 7 2\n"), "elements of type 7 (a pyramid) are unknown", "2 2 7 2");
  for (char const* type : {"8", "14", "16", "21", "92"})
    refused(with("2 2 2 2\n", std::string("2 2 ") + type + " 2\n"),
            "(of second or higher order: ask Gmsh for Mesh.ElementOrder = 1)", "");
  refused(with("2 2 2 2\n", "2 2 34 2\n"), "elements of type 34 (a polygon or a polyhedron) are unknown",
          "2 2 34 2");
  refused(with("\n9\n", "\n0\n"), "the tag of a node lies between 1 and 2^31, and is 0",
          "0\n0 0 0\n1 0 0\n1 1");
  refused(with("\n9\n", "\n2147483648\n"), "and is 2147483648", "2147483648");
  BOOST_TEST(
      gmsh_mesh_of(with("3 1 5 9", "3 1 5 2147483647", with("\n9\n", "\n2147483647\n")), "").nodes.size() ==
      4);
  refused(with("3 1 5 9", "3 1 5 8"), "a triangle has node 8, which the file does not have", "3 1 5 8");
  refused(with("3 1 5 9", "3 1 5 11"), "a triangle has node 11, which the file does not have", "3 1 5 11");
  BOOST_TEST(gmsh_mesh_of(with("1 1 3\n", "1 1 5\n"), "").inside.size() == 2);
  BOOST_TEST(gmsh_mesh_of(with("1 1 3\n", "1 3 9\n"), "").no_sides.size() == 2);
  refused(with("1 0 0\n1 1 0\n", "1 0 0\n1 1 1\n"),
          "node 5 at (1, 1, 1) is not in the plane along X and Y through (0, 0, 0)", "5\n9\n0 0 0");
  auto const line = with("2 2 2 2\n2 1 3 5\n3 1 5 9\n", "1 3 1 1\n2 3 5\n", with("2 3 1 3", "2 2 1 3"));
  refused(line, "node 5 at (1, 1, 0) is not in the line along X through (0, 0, 0)", "5\n9\n0 0 0");
  refused(with("2 3 1 3\n1 3 1 1\n1 1 3\n2 2 2 2\n2 1 3 5\n3 1 5 9\n", "0 0 0 0\n"), "the file has no cells",
          "");
  refused(with("2 3 1 3", "x 3 1 3"), "should be a number, and is 'x'", "x 3 1 3");
  refused(with("2 3 1 3", "2.5 3 1 3"), "should be a number, and is '2.5'", "2.5 3 1 3");
}

// In digits a number takes two bytes, the last one perhaps a single byte; in bytes what it takes.
BOOST_AUTO_TEST_CASE(counts_are_taken_as_long_as_the_rest_of_the_file_has_room) {
  GmshCursor digits("1 2 3 4 5 6", "sample");
  BOOST_TEST(digits.left() == 11);
  BOOST_TEST(digits.checked(6, 1, 8, "things") == 6);
  BOOST_TEST(digits.checked(3, 2, 8, "things") == 3);
  auto const room = [](GmshCursor const& at, std::size_t count, std::size_t numbers, int has) {
    BOOST_CHECK_EXCEPTION(at.checked(count, numbers, 8, "things"), NotAGmshFile, [&](NotAGmshFile const& e) {
      return std::string(e.what()).find(std::to_string(count) +
                                        " things are announced, and the file has room for " +
                                        std::to_string(has)) != std::string::npos;
    });
  };
  room(digits, 7, 1, 6), room(digits, 4, 2, 3);
  BOOST_TEST(digits.in_digits<int>("a number") == 1);
  room(digits, 6, 1, 5);
  std::string const bytes(24, '\1');
  GmshCursor binary(bytes, "sample");
  binary.binary = true;
  BOOST_TEST(binary.checked(3, 1, 8, "things") == 3);
  room(binary, 4, 1, 3);
  BOOST_TEST(binary.number<int>("a number") == 0x01010101);
  BOOST_TEST((binary.at() == 4 && binary.last() == 0 && binary.left() == 20));
  binary.number<double>("x"), binary.number<double>("x");
  BOOST_TEST(binary.number<int>("a number") == 0x01010101);
  BOOST_TEST(binary.left() == 0);
  BOOST_CHECK_EXCEPTION(binary.number<int>("a number"), NotAGmshFile, [](NotAGmshFile const& e) {
    return e.byte == 24 && std::string(e.what()) == "sample, byte 24: the file ends where a number should be";
  });
  // Letters that no screen shows.
  std::string const letters = "ab\x01\x7f~ z";
  GmshCursor strange(letters, "sample");
  BOOST_CHECK_EXCEPTION(strange.expect("x"), NotAGmshFile, [](NotAGmshFile const& e) {
    return std::string(e.what()).find("x is needed, and 'ab??~' is found") != std::string::npos;
  });
}

BOOST_AUTO_TEST_SUITE_END()
