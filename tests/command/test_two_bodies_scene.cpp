// Two bodies that attract each other, through the command: known values, Kepler's orbits, what the impact of
// DART tells of the moon, and what is refused.
#include <boost/test/unit_test.hpp>

#include <numbers>

#include "body_scene.hpp"

using command::apart, command::BodyScene, command::contains, command::last;

namespace {

constexpr double pi = std::numbers::pi;

/// A number with all of its digits.
std::string digits(double x) {
  char text[32];
  std::snprintf(text, sizeof text, "%.17g", x);
  return text;
}

/// Didymos and its moon to order 2, over a radian of the orbit: the data of the README of a public code.
constexpr double radian = 7207.355394450768;
BodyScene didymos() {
  double const roll = pi / 18;
  return {
      "kind = 'two_bodies'\norder = 2\nG = 6.674e-11\n"
      "primary = { ellipsoid = [400, 395, 340], density = 2170 }\n"
      "secondary = { ellipsoid = [85, 73, 63], density = 2400 }",
      "position = [1195, 0, 0]\nvelocity = [0, 0.1735, 0]\n"
      "primary = { attitude = { axis = [0, 1, 0], degrees = 3 }, angular_velocity = [0, 0, " +
          digits(2 * pi / 8136) +
          "] }\nsecondary = { attitude = { axis = [1, 0, 0], degrees = 10 }, angular_velocity = [0, " +
          digits(std::sin(roll) / radian) + ", " + digits(std::cos(roll) / radian) + "] }",
      "step = " + digits(radian / 16), "until = " + digits(radian),
      "'relative_position', 'momentum', 'energy', 'separation', 'position'"};
}

/// Two balls on an ellipse.
constexpr double G = 6.67430e-11, half_axis = 2000, eccentricity = 0.3, masses = 4.5e12;
double const period = 2 * pi * std::sqrt(half_axis * half_axis * half_axis / (G * masses));
BodyScene const balls{
    "kind = 'two_bodies'\nprimary = { sphere = 400, mass = 4e12 }\n"
    "secondary = { sphere = 100, mass = 5e11 }",
    "orbit = { a = 2000, e = 0.3, i = 20, node = 30, pericentre = 50, time = 10, degrees = true }", "",
    "until = " + digits(period), "'elements', 'mean_period', 'precession', 'separation'"};

BodyScene changed(BodyScene scene, std::string BodyScene::*part, std::string const& from,
                  std::string const& to) {
  std::string& text = scene.*part;
  text.replace(text.find(from), from.size(), to);
  return scene;
}

}  // namespace

BOOST_AUTO_TEST_SUITE(two_bodies_scene)

BOOST_AUTO_TEST_CASE(didymos_is_where_another_code_has_it_after_a_radian) {
  // From steps of order 8 in 64 bits of mantissa, of a program of its own; a public code of order 7 agrees to
  // its tolerance, 3e-13.
  double const known[] = {-0.172030545819458, 1.023810408339441, 0.028078215610872};
  auto const left = command::run(didymos());
  BOOST_TEST(left.outcome.status == 0, left.outcome.err);
  auto const row = last(left);
  BOOST_REQUIRE(row.size() == 11u);
  for (std::size_t i = 0; i < 3; ++i) BOOST_TEST(std::abs(row[i] / 1195 - known[i]) <= 1e-11);
  // As far from the first body in its axes as in those of space.
  BOOST_TEST(std::abs(std::hypot(row[0], row[1], row[2]) - row[7]) <= 1e-12 * row[7]);
  // The scheme of Moser and Veselov in such long steps is far away: the check can fail.
  auto scene = didymos();
  scene.method += "\nname = 'moser_veselov'";
  BOOST_TEST(std::abs(last(command::run(scene))[0] / 1195 - known[0]) > 1e-3);
}

BOOST_AUTO_TEST_CASE(two_balls_go_around_on_keplers_ellipse) {
  auto const left = command::run(balls);
  BOOST_TEST(left.outcome.status == 0, left.outcome.err);
  auto const row = last(left);
  BOOST_REQUIRE(row.size() == 9u);
  // Roundings of some dozens of steps, over the eccentricity where the pericentre is meant.
  double const degree = pi / 180, anomaly = 2 * pi * (1 - 10 / period);
  std::vector<double> const expected{half_axis,   eccentricity, 20 * degree, 30 * degree,
                                     50 * degree, anomaly,      period};
  for (std::size_t i = 0; i < expected.size(); ++i)
    BOOST_TEST(std::abs(row[i] / expected[i] - 1) <= 1e-12, i << ": " << digits(row[i]));
  BOOST_TEST(row[7] == 0);  // one pericentre, no line
  // Two and a half revolutions later there are three, which stand still.
  auto later = balls;
  later.run = "until = " + digits(2.5 * period);
  BOOST_TEST(std::abs(last(command::run(later))[7]) * period <= 1e-3);
}

BOOST_AUTO_TEST_CASE(rows_between_steps_are_on_the_orbit) {
  auto scene = balls;
  scene.quantities = "'separation'";
  scene.method = "step = " + digits(period / 64);
  scene.run = "until = " + digits(period) + "\nat = [" + digits(0.123 * period) + ", " +
              digits(0.77 * period) + ", " + digits(period) + "]\nbetween_steps = true";
  auto const between = command::run(scene);
  BOOST_TEST(between.outcome.status == 0, between.outcome.err);
  // Kepler's equation by bisection.
  for (auto const& row : between.table.rows) {
    double const M = std::remainder(2 * pi * (row[0] - 10) / period, 2 * pi);
    double low = -pi, high = pi;
    for (int k = 0; k < 60; ++k) {
      double const E = (low + high) / 2;
      (E - eccentricity * std::sin(E) > M ? high : low) = E;
    }
    BOOST_TEST(std::abs(row[1] / (half_axis * (1 - eccentricity * std::cos(low))) - 1) <= 1e-12);
  }
}

BOOST_AUTO_TEST_CASE(the_methods_have_their_orders) {
  auto scene = didymos();
  scene.quantities = "'relative_position'";
  scene.method = "step = " + digits(radian / 64);
  auto const truth = last(command::run(scene));
  for (auto const& [method, order, steps] : {std::tuple("name = 'splitting'\norder = 2", 2, 128),
                                             {"name = 'splitting'\norder = 4", 4, 32},
                                             {"name = 'moser_veselov'", 2, 512}}) {
    std::vector<double> errors;
    for (int k = 0; k < 3; ++k) {
      scene.method = std::string(method) + "\nstep = " + digits(radian / (steps << k));
      errors.push_back(apart(last(command::run(scene)), truth));
    }
    BOOST_TEST(std::abs(command::order_of(errors) - order) < 0.2,
               method << " has order " << command::order_of(errors));
  }
}

BOOST_AUTO_TEST_CASE(the_error_that_a_run_tells_is_about_the_true_one) {
  // That of attitudes: of the moon, which turns by the least exact part of the steps.
  auto scene = didymos();
  scene.quantities = "'attitude_2'", scene.run = "until = " + digits(20 * radian);
  scene.method = "step = " + digits(radian / 64);
  auto const truth = last(command::run(scene));
  for (auto const& [method, steps] : {std::pair("", 8), {"", 10}, {"name = 'splitting'", 16}}) {
    scene.method = std::string(method) + "\nstep = " + digits(radian / steps);
    auto const left = command::run(scene);
    auto const q = last(left);
    double square = 0;
    for (std::size_t i = 0; i < 4; ++i) square += (q[i] - truth[i]) * (q[i] - truth[i]);
    double const error = 2 * std::sqrt(square);  // the angle, where it is small
    std::size_t const at = left.summary.find("\"attitude\": ", left.summary.find("\"error\": "));
    double const told = std::strtod(left.summary.c_str() + at + 12, nullptr);
    BOOST_TEST_MESSAGE(steps << " steps a radian: told " << told << ", true " << error);
    BOOST_TEST((told > 0.3 * error && told < 10 * error), told << " for " << error);
  }
}

BOOST_AUTO_TEST_CASE(the_tangent_map_is_that_of_moved_starts) {
  auto scene = didymos();
  scene.quantities = "'position', 'tangent_map', 'lyapunov'";
  auto const row = last(command::run(scene));
  BOOST_REQUIRE(row.size() == 3u + 18 * 18 + 1);
  double const shift = 0.01;  // of which the third power is left out: 1e-10 of a relative error
  auto const end = [&](double x) {
    return last(command::run(changed(scene, &BodyScene::initial, "[1195,", "[" + digits(1195 + x) + ",")));
  };
  auto const up = end(shift), down = end(-shift);
  for (std::size_t i = 0; i < 3; ++i)
    BOOST_TEST(std::abs((up[i] - down[i]) / (2 * shift) - row[3 + 18 * i]) <= 1e-8 * 10);
  BOOST_TEST(row.back() > 0);
}

BOOST_AUTO_TEST_CASE(the_sensitivity_is_that_of_moved_starts) {
  auto scene = didymos();
  scene.quantities = "'separation', 'sensitivity'";
  auto const row = last(command::run(scene));
  BOOST_REQUIRE(row.size() == 1u + 18);
  double const roll = pi / 18, turning = 2 * pi / 8136;
  // One entry of each of the six parts: what stands in the scene, its value, the shift, and by how much the
  // entry changes with the value.
  struct Entry {
    std::size_t at;
    std::string before, after;
    double value, shift, unit;
  };
  std::vector<Entry> const entries{
      {0, "[1195,", "[#,", 1195, 0.1, 1},
      {4, "[0, 0.1735,", "[0, #,", 0.1735, 1e-5, 1},
      {7, "degrees = 3 ", "degrees = # ", 3, 0.05, pi / 180},
      {11, "[0, 0, " + digits(turning), "[0, 0, #", turning, turning * 1e-3, 1},
      {12, "degrees = 10 ", "degrees = # ", 10, 0.05, pi / 180},
      {17, ", " + digits(std::cos(roll) / radian), ", #", std::cos(roll) / radian, 1e-3 / radian, 1}};
  for (auto const& e : entries) {
    auto const end = [&](double shift) {
      auto after = e.after;
      after.replace(after.find('#'), 1, digits(e.value + shift));
      return last(command::run(changed(scene, &BodyScene::initial, e.before, after)))[0];
    };
    // Central differences with shifts h and 2h, from which the square of h drops out.
    double const one = (end(e.shift) - end(-e.shift)) / (2 * e.shift),
                 two = (end(2 * e.shift) - end(-2 * e.shift)) / (4 * e.shift),
                 difference = (4 * one - two) / 3 / e.unit,
                 // the fourth power of a thousandth, and the rounding of a distance over the shift
        bound = 1e-9 * std::abs(difference) + 1e-12 * 1195 / (e.shift * e.unit);
    BOOST_TEST_MESSAGE("entry " << e.at << ": " << row[1 + e.at] << ", differences " << difference);
    BOOST_TEST(std::abs(difference - row[1 + e.at]) <= bound);
    BOOST_TEST(std::abs(difference) > 100 * bound);
  }
}

BOOST_AUTO_TEST_CASE(the_precession_after_the_impact_tells_the_shape_of_the_moon) {
  // Degrees a day, to the digits that a prototype of the same equations printed, which takes the pericentre
  // from a parabola through three steps.
  struct Member {
    char const* half_axes;
    double precession;
  };
  std::vector<Member> const members{{"[89.9919281649714, 88.22738055389352, 56.24495510310712]", 13.640},
                                    {"[92.28569663093839, 83.89608784630762, 57.678560394336486]", 12.757},
                                    {"[95.00152610660132, 79.16793842216777, 59.37595381662582]", 10.305},
                                    {"[96.30307861134816, 77.04246288907852, 60.1894241320926]", 8.320},
                                    {"[96.94086593073585, 76.03205171038107, 60.5880412067099]", 7.092},
                                    {"[97.57036971192117, 75.05413054763167, 60.98148106995073]", 5.741},
                                    {"[98.80556880979228, 73.18931022947575, 61.75348050612017]", 2.878},
                                    {"[100.0106335359057, 71.43616681136122, 62.50664595994106]", 0.168}};
  std::string over;
  for (auto const& member : members) over += (over.empty() ? "" : ",") + std::string(member.half_axes);
  command::Folder const folder;
  auto const outcome =
      command::actio({"sweep", "didymos_after", "--over", "system.secondary.ellipsoid=" + over, "--set",
                      "output.quantities=['precession']", "--quiet", "--out", folder / "sweep"});
  BOOST_TEST(outcome.status == 0, outcome.err);
  for (std::size_t k = 0; k < members.size(); ++k) {
    auto const table = command::read_csv(folder / "sweep/00000" + std::to_string(k) + "/series.csv");
    double const found = table.rows.back()[1] * 86400 * 180 / pi;
    BOOST_TEST_MESSAGE(members[k].half_axes << ": " << found << " degrees a day");
    BOOST_TEST(std::abs(found - members[k].precession) <= 1e-3);
  }
}

BOOST_AUTO_TEST_CASE(what_is_wrong_is_refused_with_what_was_measured) {
  struct Wrong {
    std::string BodyScene::*part;
    char const *from, *to, *says;
  };
  for (auto const& [part, from, to, says] : std::vector<Wrong>{
           {&BodyScene::initial, "[1195, 0, 0]", "[480, 0, 0]",
            "position: the bodies are too near for the series of their potential: the radii of the spheres "
            "about them, 400 and 85, are 1.01 of the distance 480 together, and less than 1 is needed"},
           {&BodyScene::system, "density = 2170", "density = -1", "found -1"},
           {&BodyScene::system, "density = 2170", "density = 2170, mass = 1",
            "density and mass exclude each other"},
           {&BodyScene::system, ", density = 2170", "", "'density' or 'mass' is needed"},
           {&BodyScene::system, "[400, 395, 340]", "[400, 0, 340]", "a half axis must be > 0, found 0"},
           {&BodyScene::system, "ellipsoid = [400, 395, 340]", "ellipsoid = [400, 395, 340], sphere = 400",
            "ellipsoid and sphere exclude each other"},
           {&BodyScene::system, "ellipsoid = [85, 73, 63], density = 2400",
            "radius = 85, moments = [[0, 0, 0, 4], [2, 0, 0, 1], [0, 2, 0, 1], [0, 0, 2, -1]]",
            "I_1 must be positive"},
           {&BodyScene::system, "ellipsoid = [85, 73, 63], density = 2400",
            "radius = 85, moments = [[0, 0, 0.5, 4]]", "exponents are whole numbers, 0 or more"},
           {&BodyScene::system, "ellipsoid = [85, 73, 63], density = 2400",
            "body = 'apophis', mass = 1, radius = 1", "those of apophis are in: ratio"},
           {&BodyScene::initial, "velocity = [0, 0.1735, 0]", "orbit = { a = 1195 }",
            "orbit excludes position and velocity"},
           {&BodyScene::quantities, "'energy'", "'lyapunoff'", "did you mean 'lyapunov'"}}) {
    auto const left = command::run(changed(didymos(), part, from, to));
    BOOST_TEST(left.outcome.status == 2, to << ": " << left.outcome.err);
    BOOST_TEST(contains(left.outcome.err, says), to << ": " << left.outcome.err);
  }
}

BOOST_AUTO_TEST_CASE(bodies_that_come_too_near_on_the_way_end_the_run_with_its_rows) {
  auto scene = changed(didymos(), &BodyScene::initial, "[0, 0.1735, 0]", "[0, 0.01, 0]");
  scene.method = "step = 60", scene.run = "until = 60000\nevery = 60";
  auto const left = command::run(scene);
  BOOST_TEST(left.outcome.status == 3);
  BOOST_TEST(contains(left.outcome.err, "the spheres about the bodies must not meet"), left.outcome.err);
  BOOST_TEST(left.table.rows.size() > 10u);
  // They are seen where no row is.
  scene.run = "until = 60000";
  BOOST_TEST(command::run(scene).outcome.status == 3);
}

BOOST_AUTO_TEST_CASE(remarks_tell_what_to_doubt) {
  auto const near =
      command::run(changed(didymos(), &BodyScene::initial, "[1195, 0, 0]\nvelocity = [0, 0.1735, 0]",
                           "[700, 0, 0]\nvelocity = [0, 0.24, 0]"));
  BOOST_TEST(contains(near.outcome.err, "are 0.69 of the distance together"), near.outcome.err);
  auto const odd = command::run(changed(didymos(), &BodyScene::system, "order = 2", "order = 3"));
  BOOST_TEST(contains(odd.outcome.err, "3 is the same as 2"), odd.outcome.err);
  auto fast = didymos();
  fast.method = "step = " + digits(radian / 4);
  BOOST_TEST(contains(command::run(fast).outcome.err, "of a revolution in a step"));
}

BOOST_AUTO_TEST_CASE(a_shape_is_shifted_and_turned_to_its_principal_axes) {
  // A box of 2 by 4 by 6, a corner at the origin, in half metres.
  std::string const box =
      "v 0 0 0\nv 2 0 0\nv 2 4 0\nv 0 4 0\nv 0 0 6\nv 2 0 6\nv 2 4 6\nv 0 4 6\n"
      "f 1 4 3 2\nf 5 6 7 8\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n";
  command::Folder const folder;
  folder.write("box.obj", box);
  BodyScene const scene{
      "kind = 'two_bodies'\norder = 2\nprimary = { shape = 'box.obj', length_unit = 0.5, mass = 6e3 }\n"
      "secondary = { sphere = 0.5, mass = 1e3 }",
      "position = [0, 0, 10]\nvelocity = [1e-4, 0, 0]", "", "until = 100", "'potential'"};
  auto const outcome =
      command::actio({"run", "--out", folder / "out", folder.write("scene.toml", scene.text())});
  BOOST_TEST(outcome.status == 0, outcome.err);
  BOOST_TEST(contains(outcome.err, "the centre of mass is at (0.5, 1, 1.5) of the file"), outcome.err);
  // Of the box and a ball: -G m (m1/r + (tr I - 3 I_zz)/(2 r^3)), with I_zz = m1 (1 + 4)/12 and the trace
  // m1 (1 + 4 + 9)/6.
  double const expected = -G * 1e3 * 6e3 * (1 / 10. + (14 / 6. - 15 / 12.) / 2e3),
               found = command::read_csv(folder / "out/series.csv").rows.front()[1];
  BOOST_TEST(std::abs(found / expected - 1) <= 1e-14);
  std::string open = box;
  open.resize(open.rfind("f 4 1"));
  folder.write("box.obj", open);
  auto const refused = command::actio({"run", "--out", folder / "open", folder / "scene.toml"});
  BOOST_TEST(refused.status == 2);
  BOOST_TEST(contains(refused.err, "shape: "), refused.err);
}

BOOST_AUTO_TEST_SUITE_END()
