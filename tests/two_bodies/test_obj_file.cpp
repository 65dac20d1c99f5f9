// Shapes as texts in the format .obj.
#include <boost/test/unit_test.hpp>

#include <filesystem>
#include <fstream>

#include "actio/two_bodies/obj_file.hpp"
#include "refused.hpp"

using namespace actio;
using namespace actio::bodies;

namespace {
std::string const cube =
    "# a cube, with faces of four vertices, of normals and from the end\n"
    "v -1 -1 -1\nv 1 -1 -1\nv 1 1 -1\nv -1 1 -1\nv -1 -1 1\nv 1 -1 1\nv 1 1 1\nv -1 1 1\n"
    "vn 0 0 1\ng sides\nf 4 3 2 1\nf 5//1 6//1 7//1 8//1\nf 1/1 2/2 6/3 5/4\n"
    "f -6 -5 -1 -2\nf 2 3 7 6\nf 1 5 8 4\n";
}  // namespace

BOOST_AUTO_TEST_SUITE(obj_file)

BOOST_AUTO_TEST_CASE(a_cube_is_read_with_all_ways_to_name_a_vertex) {
  auto const body = parse_obj(cube, 10);
  BOOST_TEST(body.vertices.size() == 8u);
  BOOST_TEST(body.faces.size() == 12u);
  auto const moments = polyhedron_moments<double>(body, 1, 2);
  BOOST_TEST(std::abs(moments.mass() - 8e3) <= 1e-11);
  BOOST_TEST(std::abs(moments(2, 0, 0) - 8e5 / 3) <= 1e-9);
  auto const path = std::filesystem::temp_directory_path() / "actio_cube.obj";
  std::ofstream(path) << cube;
  BOOST_TEST((read_obj(path.string(), 10).vertices == body.vertices));
  std::filesystem::remove(path);
}

BOOST_AUTO_TEST_CASE(what_has_no_meaning_is_refused_with_its_line) {
  CHECK_REFUSED(parse_obj("v 0 0 0\nv 1 0\n"), ShapeError);
  CHECK_REFUSED(parse_obj("v 0 0 0\nv 1 0 0\nf 1 2\n"), ShapeError);
  CHECK_REFUSED(parse_obj("v 0 0 0\nv 1 0 0\nf 1 2 3\n"), ShapeError);
  CHECK_REFUSED(parse_obj("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 two 3\n"), ShapeError);
  CHECK_REFUSED(parse_obj("v 0 0 0\n"), ShapeError);
  CHECK_REFUSED(parse_obj(cube, 0), OutsideDomain);
  CHECK_REFUSED(read_obj("there/is/no/such.obj"), ShapeError);
}

BOOST_AUTO_TEST_SUITE_END()
