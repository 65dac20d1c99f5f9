// An attitude as a quaternion, as a rotation matrix and as a turn about an axis; angular velocities in
// degrees.
#include <boost/test/unit_test.hpp>

#include <cmath>
#include <numbers>
#include <sstream>

#include "command.hpp"

namespace {

using command::actio;

bool has(std::string const& text, std::string const& part) { return text.find(part) != std::string::npos; }

std::string in_toml(double x) {
  std::ostringstream out;
  out.precision(17);
  out << x;
  return out.str();
}

std::string body(std::string const& attitude, std::string const& velocity = "[0.3, 0.2, 1.1]") {
  return "[system]\nkind = \"rigid_body\"\ninertia = [1, 2, 2.5]\n[initial]\nattitude = " + attitude +
         "\nangular_velocity = " + velocity +
         "\n[run]\nuntil = 3\nevery = 0.5\n[output]\n"
         "quantities = [\"attitude\", \"body_momentum\", \"spatial_momentum\"]\n";
}
std::string top(std::string const& attitude, std::string const& velocity = "[0.3, 0.2, 11]") {
  return "[system]\nkind = \"heavy_top\"\nmass = 1\ninertia = [1, 1, 0.5]\ncentre_of_mass = [0, 0, "
         "1]\ngravity = [0, 0, -9.81]\n[initial]\nattitude = " +
         attitude + "\nangular_velocity = " + velocity +
         "\n[run]\nuntil = 0.2\nevery = 0.1\n[output]\n"
         "quantities = [\"attitude\", \"body_momentum\", \"energy\"]\n";
}

/// The table that a scene leaves; and that its copy leaves the same is required.
std::string series(std::string const& scene) {
  command::Folder const folder;
  auto const outcome = actio({"run", folder.write("scene.toml", scene), "--out", folder / "one"});
  BOOST_TEST(outcome.status == 0, outcome.err);
  BOOST_TEST(actio({"run", folder / "one/scene.toml", "--out", folder / "two"}).status == 0);
  std::string const table = command::contents(folder / "one/series.csv");
  BOOST_TEST(table == command::contents(folder / "two/series.csv"), "the copy of the scene is another one");
  return table;
}

std::vector<double> start(std::string const& scene) {
  command::Folder const folder;
  folder.write("series.csv", series(scene));
  return command::read_csv(folder / "series.csv").rows.front();
}

void are_close(std::string const& scene, std::vector<double> const& quaternion) {
  auto const row = start(scene);
  for (std::size_t i = 0; i < 4; ++i)
    BOOST_TEST(std::abs(row[1 + i] - quaternion[i]) <= 3e-16,
               scene << " component " << i << " is " << row[1 + i]);
}

std::string complaint(std::string const& scene, std::vector<std::string> const& more = {}) {
  command::Folder const folder;
  std::string const path = folder.write("scene.toml", scene);
  std::vector<std::string> arguments{"run", path};
  arguments.insert(arguments.end(), more.begin(), more.end());
  auto const outcome = actio(arguments);
  BOOST_TEST(outcome.status == 2, scene);
  return outcome.err.starts_with(path) ? outcome.err.substr(path.size()) : outcome.err;
}

}  // namespace

BOOST_AUTO_TEST_SUITE(attitude)

BOOST_AUTO_TEST_CASE(quarter_turns_are_the_same_to_the_last_bit_in_every_form) {
  for (bool const free : {true, false}) {
    auto const make = [free](std::string const& attitude) { return free ? body(attitude) : top(attitude); };
    std::string const half = series(make("[0, 1, 0, 0]"));
    BOOST_TEST((series(make("{ axis = [1, 0, 0], degrees = 180 }")) == half));
    BOOST_TEST((series(make("{ axis = [7, 0, 0], degrees = 180 }")) == half));
    BOOST_TEST((series(make("[[1, 0, 0], [0, -1, 0], [0, 0, -1]]")) == half));
    std::string const none = series(make("[1, 0, 0, 0]"));
    BOOST_TEST((series(make("{ axis = [1, 2, 3], degrees = 0 }")) == none));
    BOOST_TEST((series(make("{ axis = [1, 2, 3], degrees = 720 }")) == none));
    BOOST_TEST((series(make("{ axis = [1, 2, 3], radians = 0 }")) == none));
    BOOST_TEST((series(make("[[1, 0, 0], [0, 1, 0], [0, 0, 1]]")) == none));
  }
}

BOOST_AUTO_TEST_CASE(a_turn_about_an_axis_is_the_quaternion_of_half_its_angle) {
  double const c = std::cos(std::numbers::pi / 12), s = std::sin(std::numbers::pi / 12) / std::sqrt(14.0);
  are_close(body("{ axis = [1, -2, 3], degrees = 30 }"), {c, s, -2 * s, 3 * s});
  are_close(body("{ axis = [1e-200, -2e-200, 3e-200], degrees = 30 }"), {c, s, -2 * s, 3 * s});
  are_close(body("{ axis = [1e300, -2e300, 3e300], degrees = 30 }"), {c, s, -2 * s, 3 * s});
  are_close(body("{ axis = [-1, 2, -3], degrees = -30 }"), {c, s, -2 * s, 3 * s});
  // Once round more is the other of the two quaternions.
  are_close(body("{ axis = [1, -2, 3], degrees = 390 }"), {-c, -s, 2 * s, -3 * s});
  are_close(top("{ axis = [0, 1, 0], radians = 0.5 }"), {std::cos(0.25), 0, std::sin(0.25), 0});
  are_close(body("{ axis = [1, 0, 0], degrees = 90 }"), {std::sqrt(0.5), std::sqrt(0.5), 0, 0});
}

BOOST_AUTO_TEST_CASE(a_rotation_matrix_is_its_quaternion_wherever_its_largest_component_is) {
  for (std::vector<double> q : {std::vector<double>{0.9, 0.3, -0.2, 0.1},
                                {0.1, 0.9, 0.3, -0.2},
                                {0.2, -0.1, 0.9, 0.3},
                                {0.3, 0.2, -0.1, 0.9}}) {
    double const length = std::sqrt(q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3]);
    for (double& x : q) x /= length;
    double const w = q[0], x = q[1], y = q[2], z = q[3];
    std::vector<double> const rows{1 - 2 * (y * y + z * z), 2 * (x * y - w * z),     2 * (x * z + w * y),
                                   2 * (x * y + w * z),     1 - 2 * (x * x + z * z), 2 * (y * z - w * x),
                                   2 * (x * z - w * y),     2 * (y * z + w * x),     1 - 2 * (x * x + y * y)};
    std::string matrix;
    for (std::size_t i = 0; i < 9; ++i) matrix += (i == 0 ? "[[" : i % 3 ? ", " : "], [") + in_toml(rows[i]);
    are_close(body(matrix + "]]"), q);
  }
}

BOOST_AUTO_TEST_CASE(angular_velocities_in_degrees_are_those_in_radians_to_the_last_bit) {
  auto const radians = [](double degrees) { return in_toml(degrees * (std::numbers::pi / 180)); };
  std::string const list = "[" + radians(10) + ", " + radians(20) + ", " + radians(-30.5) + "]",
                    degrees = "{ degrees = [10, 20, -30.5] }";
  BOOST_TEST((series(body("[1, 0, 0, 0]", degrees)) == series(body("[1, 0, 0, 0]", list))));
  BOOST_TEST((series(top("[1, 0, 0, 0]", degrees)) == series(top("[1, 0, 0, 0]", list))));
  std::string const plane =
      "[system]\nkind = \"rigid_body_n\"\nlambda = [1, 2]\n[run]\nuntil = 1\n[output]\n"
      "quantities = [\"momentum\"]\n[initial]\nangular_velocity = ";
  BOOST_TEST((series(plane + "{ degrees = [90] }\n") == series(plane + "[" + radians(90) + "]\n")));
}

BOOST_AUTO_TEST_CASE(a_turn_can_be_swept_and_set_by_its_angle) {
  command::Folder const folder;
  std::string const path = folder.write("scene.toml", body("{ axis = [0, 0, 1], degrees = 30 }"));
  BOOST_TEST(actio({"run", path, "--set", "initial.attitude.degrees=180", "--out", folder / "set"}).status ==
             0);
  BOOST_TEST((command::contents(folder / "set/series.csv") == series(body("[0, 0, 0, 1]"))));
  BOOST_TEST(
      actio({"sweep", path, "--over", "initial.attitude.degrees=0,180", "--out", folder / "swept"}).status ==
      0);
  BOOST_TEST((command::contents(folder / "swept/000001/series.csv") == series(body("[0, 0, 0, 1]"))));
  // A whole attitude over another one leaves nothing of it.
  BOOST_TEST(actio({"run", path, "--set", "initial.attitude={ axis = [0, 0, 1], radians = 0 }", "--out",
                    folder / "radians"})
                 .status == 0);
  BOOST_TEST(
      actio({"run", path, "--set", "initial.attitude=[1, 0, 0, 0]", "--out", folder / "quaternion"}).status ==
      0);
  BOOST_TEST((command::contents(folder / "radians/series.csv") ==
              command::contents(folder / "quaternion/series.csv")));
}

BOOST_AUTO_TEST_CASE(a_matrix_off_a_rotation_by_rounding_is_normalised_and_said) {
  command::Folder const folder;
  std::string const near = body("[[1, 0, 0], [0, 0, -1.0000000003], [0, 1, 0]]");
  BOOST_TEST(actio({"run", folder.write("scene.toml", near)}).status == 0);
  BOOST_TEST(has(command::contents(folder / "scene/summary.json"), "attitude: off a rotation by 6e-10"));
  are_close(near, {std::sqrt(0.5), std::sqrt(0.5), 0, 0});
}

BOOST_AUTO_TEST_CASE(what_is_no_attitude_is_refused_at_its_place) {
  auto const begins = [](std::string const& attitude, std::string const& said) {
    std::string const found = complaint(body(attitude));
    BOOST_TEST(found.starts_with(said), found << "instead of " << said);
  };
  begins("{ axis = [0, 0, 0], degrees = 30 }", ":5:21: axis: a direction is expected, found one of length 0");
  begins("{ axis = [0, 0, 1] }", ":5:12: attitude: a turn needs 'degrees' or 'radians' beside its axis");
  begins("{ degrees = 30 }", ":5:12: attitude: a turn needs 'axis'");
  begins("{ }", ":5:12: attitude: a turn needs 'axis'");
  begins("{ axis = [0, 0, 1], degrees = 30, radians = 1 }",
         ":5:42: attitude: degrees and radians exclude each other");
  begins("{ axis = [0, 0, 1], degres = 30 }",
         ":5:32: unknown key of [initial.attitude] 'degres'; did you mean 'degrees'?");
  begins("{ axis = [0, 0, 1], degrees = nan }", ":5:42: degrees: a finite number is expected");
  begins("{ axis = [0, inf, 1], degrees = 3 }", ":5:25: axis: a finite number is expected");
  begins("{ axis = [0, 1], degrees = 3 }", ":5:21: axis: 3 numbers are expected, found 2");
  begins("{ axis = [0, 0, 1], degrees = \"30\" }", ":5:42: degrees: a number is expected");
  begins("[[1, 0, 0], [0, 0, 1], [0, 1, 0]]",
         ":5:12: attitude: a rotation is expected, with determinant 1; this is a reflection");
  begins("[[1, 0, 0], [0, 1.1, 0], [0, 0, 1]]",
         ":5:12: attitude: a rotation is expected; the largest entry of g^T g - 1 is 0.21");
  begins("[[1, 0, 0], [0, 1, 0]]", ":5:12: attitude: 3 rows are expected, found 2");
  begins("[[1, 0, 0], [0, 1], [0, 0, 1]]", ":5:24: attitude: 3 numbers are expected, found 2");
  begins("[[1, 0, 0], [0, nan, 0], [0, 0, 1]]", ":5:28: attitude: a finite number is expected");
  begins("[1, 0, 0]", ":5:12: attitude: 4 numbers are expected, found 3");
  begins("\"up\"", ":5:12: attitude: a list of numbers is expected");
  auto const velocity = [](std::string const& value) { return complaint(body("[1, 0, 0, 0]", value)); };
  BOOST_TEST(velocity("{ degrees = [1, 2] }").starts_with(":6:32: degrees: 3 numbers are expected, found 2"));
  BOOST_TEST(velocity("{ radians = [1, 2, 3] }")
                 .starts_with(":6:22: unknown key of [initial.angular_velocity] 'radians'"));
  BOOST_TEST(velocity("{ }").starts_with(":6:20: [initial.angular_velocity] needs 'degrees'"));
  BOOST_TEST(has(complaint(body("[1, 0, 0, 0]"), {"--set", "initial.attitude.degrees=3"}),
                 "'attitude' is no table, so nothing in it can be set"));
}

BOOST_AUTO_TEST_SUITE_END()
