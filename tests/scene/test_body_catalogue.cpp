// The catalogue of bodies: what is in it, and what it says of a file that is wrong.
#include <Eigen/Core>

#include <boost/test/unit_test.hpp>

#include <unistd.h>

#include <filesystem>
#include <fstream>

#include "actio/bodies/body_catalogue.hpp"
#include "refused.hpp"

using namespace actio;
using Matrix3d = actio::Matrix<double, 3, 3>;
using Vector3d = actio::Vector<double, 3>;

namespace {
constexpr double eps = std::numeric_limits<double>::epsilon();

// A catalogue with one body, in which a line is replaced.
std::string complaint(std::string const& line, std::string const& instead) {
  std::string text =
      "[top]\ntitle = \"a top\"\nunit = \"kg m^2\"\nmoments = [1.0, 1.0, 1.5]\ntime = \"s\"\n"
      "spin = [0.0, 0.0, 1.0]\nsource = \"here\"\nderived = \"nothing\"\n";
  auto const at = text.find(line);
  BOOST_REQUIRE(at != std::string::npos);
  text.replace(at, line.size(), instead);
  std::string const name = "actio_test_bodies_" + std::to_string(getpid()) + ".toml";
  auto const file = std::filesystem::temp_directory_path() / name;
  std::ofstream(file) << text;
  try {
    read_bodies(file);
  } catch (CatalogueError const& error) {
    BOOST_TEST(std::string(error.what()).find(name) != std::string::npos);
    return error.what();
  }
  return "";
}
bool says(std::string const& text, std::string const& part) { return text.find(part) != std::string::npos; }
}  // namespace

BOOST_AUTO_TEST_SUITE(body_catalogue)

BOOST_AUTO_TEST_CASE(has_its_bodies_with_their_sources) {
  auto const bodies = read_bodies(ACTIO_DATA "/bodies.toml");
  for (char const* name : {"nesc_brick", "apophis", "toutatis", "water", "t_handle", "iss"})
    BOOST_TEST(std::any_of(bodies.begin(), bodies.end(), [&](Body const& b) { return b.name == name; }),
               name);
  for (Body const& body : bodies) {
    BOOST_TEST(!body.source.empty());
    BOOST_TEST(body.spin.coordinates.norm() > 0);
  }
  CHECK_REFUSED(read_body(ACTIO_DATA "/bodies.toml", "teapot"), CatalogueError);
}

BOOST_AUTO_TEST_CASE(computes_the_moments_of_water_which_is_planar) {
  auto const water = read_body(ACTIO_DATA "/bodies.toml", "water");
  // 0.6158144, 1.1557006, 1.7715149 atomic mass units times square angstrom.
  double const unit = 1.66053906892e-27 * 1e-20;
  Vector3d const known(0.6158144, 1.1557006, 1.7715149);
  for (int i = 0; i < 3; ++i)
    BOOST_TEST(std::abs(water.principal.inertia.moments[i] / unit - known[i]) < 2e-5);
  BOOST_TEST(water.principal.inertia.lambda[2] == 0);
}

BOOST_AUTO_TEST_CASE(converts_units_and_finds_principal_axes) {
  auto const brick = read_body(ACTIO_DATA "/bodies.toml", "nesc_brick");
  BOOST_TEST(std::abs(brick.principal.inertia.moments[0] - 0.0025682) < 1e-7);
  auto const iss = read_body(ACTIO_DATA "/bodies.toml", "iss");
  Vector3d const known(3.06517e7, 1.112493e8, 1.290039e8);
  for (int i = 0; i < 3; ++i) BOOST_TEST(std::abs(iss.principal.inertia.moments[i] / known[i] - 1) < 2e-6);
  // The velocity is in the frame of the tensor, as it is written.
  BOOST_TEST(iss.spin.coordinates == Vector3d(-9.5380685844896e-6, -1.1363312657036e-3, 5.3472801108427e-6));
  BOOST_TEST((iss.principal.axes * Eigen::Vector3d(iss.principal_spin().coordinates) -
              Eigen::Vector3d(iss.spin.coordinates))
                 .norm() < 1e-17);
}

BOOST_AUTO_TEST_CASE(the_middle_axis_of_the_t_handle_is_its_stem) {
  auto const handle = read_body(ACTIO_DATA "/bodies.toml", "t_handle");
  BOOST_TEST(std::abs(std::abs(handle.principal.axes(0, 1)) - 1) < 8 * eps);
  BOOST_TEST(std::abs(handle.principal_spin().coordinates[1]) >
             100 * std::abs(handle.principal_spin().coordinates[0]));
}

BOOST_AUTO_TEST_CASE(a_cylinder_has_the_inertia_of_its_slices) {
  // A thin rod and a thin disc from the formulas of each; and a cylinder cut in two is still the same
  // cylinder.
  Cylinder const whole{2.0, 0.3, 1.2, Vector3d::Zero(), Vector3d::UnitZ()};
  std::vector<Cylinder> const halves{{1.0, 0.3, 0.6, Vector3d(0, 0, 0.3), Vector3d::UnitZ()},
                                     {1.0, 0.3, 0.6, Vector3d(0, 0, -0.3), Vector3d(0, 0, -5)}};
  BOOST_TEST((inertia_about_centre(halves) - inertia_tensor(whole)).norm() < 8 * eps);
  BOOST_TEST(std::abs(inertia_tensor(whole)(2, 2) - 2.0 * 0.09 / 2) < eps);
  // Points: two masses at a distance have the reduced mass about their centre.
  std::vector<PointMass> const points{{1.0, Vector3d(5, 0, 0)}, {3.0, Vector3d(7, 0, 0)}};
  BOOST_TEST((inertia_about_centre(points) - Matrix3d(Vector3d(0, 3, 3).asDiagonal())).norm() < 64 * eps);
}

BOOST_AUTO_TEST_CASE(complaints_name_the_file_the_body_and_the_key) {
  BOOST_TEST(complaint("unit", "unit") == "");
  BOOST_TEST(says(complaint("[1.0, 1.0, 1.5]", "[1.0, 1.0, 3.0]"), "[top] moments"));
  BOOST_TEST(says(complaint("[1.0, 1.0, 1.5]", "[1.0, 1.0, 3.0]"), "triangle"));
  BOOST_TEST(says(complaint("[1.0, 1.0, 1.5]", "[1.0, 1.0]"), "three numbers"));
  BOOST_TEST(says(complaint("[1.0, 1.0, 1.5]", "[1.0, nan, 1.0]"), "NaN"));
  BOOST_TEST(says(complaint("[1.0, 1.0, 1.5]", "[1.0, inf, 1.0]"), "infinity"));
  BOOST_TEST(says(complaint("[1.0, 1.0, 1.5]", "\"heavy\""), "[top] moments"));
  BOOST_TEST(says(complaint("kg m^2", "pound"), "[top] unit"));
  BOOST_TEST(says(complaint("spin =", "spun ="), "spun: unknown key"));
  BOOST_TEST(says(complaint("spin = [0.0, 0.0, 1.0]", ""), "spin: is missing"));
  BOOST_TEST(says(complaint("title = \"a top\"", ""), "title: a text"));
  BOOST_TEST(says(
      complaint("moments = [1.0, 1.0, 1.5]", "tensor = [[1.0, 0.5, 0.0], [0.4, 1.0, 0.0], [0.0, 0.0, 1.0]]"),
      "symmetric"));
  BOOST_TEST(says(complaint("moments = [1.0, 1.0, 1.5]", "points = [{mass = -1.0, at = [0.0, 0.0, 0.0]}]"),
                  "mass: a positive"));
  BOOST_TEST(says(complaint("moments = [1.0, 1.0, 1.5]", "points = [{mass = 1.0, at = [0.0, 0.0, 0.0]}]"),
                  "[top] points"));
  BOOST_TEST(says(complaint("moments = [1.0, 1.0, 1.5]",
                            "cylinders = [{mass = 1.0, radius = 1.0, length = 1.0, at = [0.0, 0.0, "
                            "0.0], along = [0.0, 0.0, 0.0]}]"),
                  "along"));
  BOOST_TEST(
      says(complaint("moments = [1.0, 1.0, 1.5]", "moments = [1.0, 1.0, 1.5]\ntensor = []"), "exactly one"));
  BOOST_TEST(says(complaint("[top]", "[top"), "line 1"));
  BOOST_TEST(says(
      complaint("moments = [1.0, 1.0, 1.5]", "points = [{mass = 1.0, at = [0.0, 0.0, 0.0], heigth = 2.0}]"),
      "heigth: unknown key"));
  CHECK_REFUSED(read_bodies("/nowhere/bodies.toml"), CatalogueError);
  CHECK_REFUSED(read_bodies(std::filesystem::temp_directory_path()), CatalogueError);
}

BOOST_AUTO_TEST_SUITE_END()
