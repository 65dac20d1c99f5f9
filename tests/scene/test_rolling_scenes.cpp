// The scenes of bodies with constraints on their velocity, against their closed forms.
#include <Eigen/Core>

#include <boost/test/unit_test.hpp>

#include <cmath>
#include <numbers>

#include "last_row.hpp"

using namespace actio::scene;
using Row = std::vector<double>;
using Triple = Eigen::Vector3d;
using std::numbers::pi;

namespace {

/// All rows of a scene of the program, with some quantities.
std::vector<Row> rows_of(std::string const& name, std::string const& quantities,
                         std::vector<std::string> overrides = {}) {
  overrides.push_back("output.quantities=" + quantities);
  return rows_of(SceneFile::read(ACTIO_DATA "/scenes/" + name + ".toml", overrides));
}
Triple triple(Row const& row, std::size_t from) { return {row[from], row[from + 1], row[from + 2]}; }

/// The error of a method of order 4: its constant is below 1 for steps in units of what turns at a rate of 1,
/// and the run is as long as a few of these.
double fourth_order(double step, double rate) { return std::pow(step * rate, 4); }

/// Constraints hold to rounding in all rows, from a column on.
void check_constraints(std::vector<Row> const& rows, std::size_t from) {
  double worst = 0;
  for (auto const& row : rows)
    for (std::size_t i = from; i < row.size(); ++i) worst = std::max(worst, std::abs(row[i]));
  BOOST_TEST(worst <= 1e-13);
}

}  // namespace

BOOST_AUTO_TEST_SUITE(rolling_scenes)

BOOST_AUTO_TEST_CASE(the_sleigh_turns_right_round) {
  auto const rows = rows_of("chaplygin_sleigh", "[\"velocity\", \"configuration\", \"constraint\"]");
  // Unit mass, unit moment of inertia about the blade, the centre of mass half a unit ahead of it.
  double const V = std::hypot(rows[0][1], rows[0][2]), kappa = V / 2, c = std::asinh(rows[0][2] / rows[0][1]);
  auto const gudermann = [](double x) { return 2 * std::atan(std::tanh(x / 2)); };
  double worst = 0, turned = 0;
  for (auto const& row : rows) {
    double const s = kappa * row[0] + c, heading = 2 * (gudermann(s) - gudermann(c));
    worst = std::max({worst, std::abs(row[1] - V / std::cosh(s)), std::abs(row[2] - V * std::tanh(s)),
                      std::abs(row[4] - std::cos(heading)), std::abs(row[7] - std::sin(heading))});
    turned = heading;
  }
  BOOST_TEST_MESSAGE("sleigh: off by " << worst << ", turns by " << turned);
  BOOST_TEST(worst < fourth_order(0.05, kappa));
  // All but the ends of a whole turn, pi sqrt(J_t/m)/a = 2 pi.
  BOOST_TEST(std::abs(turned - 2 * pi) < 0.06);
  check_constraints(rows, 13);
}

BOOST_AUTO_TEST_CASE(suslovs_body_turns_over) {
  auto const rows = rows_of("suslov", "[\"velocity\", \"constraint\"]");
  double const I1 = 1, I2 = 2, root = std::hypot(rows[0][1], std::sqrt(I2) * rows[0][2]), along = 0.3 * root,
               across = 0.2 * root / std::sqrt(I2), kappa = std::hypot(along, across) / std::sqrt(I1 * I2),
               shift = std::atan2(across, along),
               phase = std::atan2(std::sqrt(I2) * rows[0][2], rows[0][1]) - shift,
               start = std::atanh(std::sin(phase)), side = std::cos(phase) < 0 ? -1 : 1;
  double worst = 0;
  for (auto const& row : rows) {
    double const s = kappa * row[0] + start, sine = std::tanh(s), cosine = side / std::cosh(s),
                 c = std::cos(shift), d = std::sin(shift);
    worst = std::max({worst, std::abs(row[1] - root * (cosine * c - sine * d)),
                      std::abs(row[2] - root * (sine * c + cosine * d) / std::sqrt(I2))});
  }
  BOOST_TEST_MESSAGE("Suslov's body: off by " << worst);
  BOOST_TEST(worst < fourth_order(0.05, root));
  check_constraints(rows, 4);
}

BOOST_AUTO_TEST_CASE(the_momentum_about_the_contact_of_chaplygins_ball_is_fixed) {
  auto const rows = rows_of("chaplygin_ball", "[\"body_momentum\", \"up\", \"constraint\"]");
  auto const about_contact = [](Row const& row) -> Triple {
    return triple(row, 1) + triple(row, 7).cross(triple(row, 4));
  };
  Triple const K = about_contact(rows[0]);
  double square = 0, vertical = 0, turns = 0;
  for (auto const& row : rows) {
    Triple const now = about_contact(row), up = triple(row, 7);
    square = std::max(square, std::abs(now.squaredNorm() / K.squaredNorm() - 1));
    vertical = std::max(vertical, std::abs(now.dot(up) - K.dot(triple(rows[0], 7))) / K.norm());
    turns = std::max(turns, (now - K).norm() / K.norm());
  }
  BOOST_TEST(square <= 1e-13);
  BOOST_TEST(vertical <= 1e-13);
  BOOST_TEST(turns > 1);
  check_constraints(rows, 11);
}

BOOST_AUTO_TEST_CASE(a_disc_falls_below_its_thresholds_and_not_above) {
  double const g = 9.81;
  auto const tilt = [](double spin, double about_the_vertical) {
    auto const number = [](double x) { return std::to_string(x); };
    auto const rows = rows_of("falling_disc", "[\"up\"]",
                              {"run.until=20",
                               "initial.velocity=[0, " + number(about_the_vertical) + ", " + number(spin) +
                                   ", " + number(-spin) + ", 0, 0]",
                               "initial.project=true"});
    double largest = 0;
    for (auto const& row : rows) largest = std::max(largest, std::abs(row[3]));
    return largest;
  };
  // Rolling at v^2 = g R/3, spinning on the spot at 4 g/(5 R).
  for (bool const rolling : {true, false}) {
    auto const at = [&](double part) {
      return rolling ? tilt(std::sqrt(part * g / 3), 0) : tilt(0, std::sqrt(part * 4 * g / 5));
    };
    double const below = at(0.9), above = at(1.1);
    BOOST_TEST_MESSAGE((rolling ? "rolling" : "spinning")
                       << ": tilt from 0.001 to " << below << " and " << above);
    BOOST_TEST(below > 0.1);
    BOOST_TEST(above < below / 10);
    // Tilted at rest the disc that rolls at r times the square of the threshold swings about r/(r - 1) of the
    // tilt; this is linear, and the tilt is not.
    if (rolling) BOOST_TEST(std::abs(above / 0.001 - 21) < 0.01 * 21);
  }
}

BOOST_AUTO_TEST_CASE(a_ball_on_a_turntable_goes_round_at_two_sevenths_of_its_rate) {
  auto const rows = rows_of("ball_on_turntable", "[\"configuration\", \"energy\", \"work\", \"constraint\"]");
  double const rate = 2 * 3 / 7.0, v1 = 0.3, v2 = 0.4;
  double worst = 0, changes = 0;
  for (auto const& row : rows) {
    double const s = std::sin(rate * row[0]) / rate, c = (1 - std::cos(rate * row[0])) / rate;
    worst = std::max({worst, std::abs(row[4] - (v1 * s - v2 * c)), std::abs(row[8] - (v1 * c + v2 * s)),
                      std::abs(row[12])});
    changes = std::max(changes, std::abs(row[17] - rows[0][17]));
    // The table does all the work.
    BOOST_TEST(std::abs(row[17] - row[18] - rows[0][17]) < fourth_order(0.025, 3));
  }
  BOOST_TEST_MESSAGE("ball on a turntable: off by " << worst << ", energy changes by " << changes);
  BOOST_TEST(worst < fourth_order(0.025, 3));
  BOOST_TEST(changes > 0.1);
  check_constraints(rows, 19);
}

BOOST_AUTO_TEST_CASE(each_stroke_of_a_snakeboard_adds_the_same_to_its_speed) {
  auto const rows = rows_of(
      "snakeboard", "[\"velocity\", \"shape\", \"constraint\"]",
      {"run.every=6.283185307179586", "run.until=31.41592653589793", "method.step=0.010471975511965977"});
  BOOST_REQUIRE_EQUAL(rows.size(), 6u);
  double const stroke = 2 * pi * 0.7 * 0.7 / (4 * 0.5) * std::cyl_bessel_j(1, 0.5);
  for (std::size_t k = 0; k < rows.size(); ++k)
    BOOST_TEST(std::abs(rows[k][4] - static_cast<double>(k) * stroke) < fourth_order(0.0105, 1) * 10);
  check_constraints(rows, 8);
}

BOOST_AUTO_TEST_CASE(a_skate_on_a_slope_runs_along_a_cycloid) {
  auto const rows = rows_of("skate", "[\"velocity\", \"configuration\", \"constraint\"]");
  double const w = 1.5, g = 0.6;
  double worst = 0, deepest = 0;
  for (auto const& row : rows) {
    double const t = row[0], s = std::sin(w * t);
    worst = std::max({worst, std::abs(row[1] - w), std::abs(row[2] - g / w * s),
                      std::abs(row[6] - g / (2 * w * w) * s * s),
                      std::abs(row[9] - g / (2 * w) * (t - std::sin(2 * w * t) / (2 * w)))});
    deepest = std::max(deepest, row[6]);
  }
  BOOST_TEST_MESSAGE("skate: off by " << worst << ", deepest at " << deepest);
  BOOST_TEST(worst < fourth_order(0.025, w));
  BOOST_TEST(deepest < g / (2 * w * w) + 1e-6);
  check_constraints(rows, 13);
}

BOOST_AUTO_TEST_CASE(contacts_stay_on_the_plane) {
  // The height of the contact is that of the centre of mass less the support function, which rolling
  // conserves: to the order of the method. The disc begins on the plane z = 0; under the rattleback it is
  // tilted.
  auto const disc = rows_of("falling_disc", "[\"contact\"]");
  double height = 0, way = 0;
  for (auto const& row : disc)
    height = std::max(height, std::abs(row[3])), way = std::max(way, std::hypot(row[1], row[2]));
  BOOST_TEST(height < fourth_order(0.01, std::sqrt(9.81)));
  BOOST_TEST(way > 1);
  auto const stone = rows_of("rattleback", "[\"contact\"]", {"run.until=1"});
  double const tilt = 0.00872653549837;
  Triple const up(tilt, tilt, 0.999923844678);
  double const first = up.dot(triple(stone[0], 1));
  // A hundred radians a second.
  for (auto const& row : stone)
    BOOST_TEST(std::abs(up.dot(triple(row, 1)) - first) < 20 * fourth_order(0.0005, 100));
}

BOOST_AUTO_TEST_CASE(a_rattleback_conserves_its_energy_where_it_is_told_to) {
  auto const rows = rows_of("rattleback", "[\"velocity\", \"energy\", \"constraint\"]",
                            {"method.name=cayley_chart", "method.conserve=energy", "method.order=2",
                             "run.until=50", "run.every=0.5"});  // a hundred thousand steps
  double change = 0, across = 0;
  for (auto const& row : rows) {
    change = std::max(change, std::abs(row[7] / rows[0][7] - 1));
    // Of the point of contact; a velocity of the body is up to 100.
    for (std::size_t i = 8; i < 11; ++i) across = std::max(across, std::abs(row[i]) / 100);
  }
  BOOST_TEST_MESSAGE("rattleback: energy changes by " << change << ", constraint " << across);
  BOOST_TEST(change <= 1e-13);
  BOOST_TEST(across <= 1e-13);
  BOOST_TEST(std::abs(rows.back()[3] - rows[0][3]) > 0.1);
}

BOOST_AUTO_TEST_CASE(the_work_of_a_turntable_is_that_of_the_energy) {
  auto const rows = rows_of("ball_on_turntable", "[\"energy\", \"work\"]",
                            {"method.name=cayley_chart", "method.conserve=energy", "method.order=2"});
  double off = 0, done = 0;
  for (auto const& row : rows)
    off = std::max(off, std::abs(row[1] - row[2] - rows[0][1])), done = std::max(done, std::abs(row[2]));
  BOOST_TEST(off <= 1e-13);
  BOOST_TEST(done > 0.1);
}

BOOST_AUTO_TEST_CASE(reactions_are_in_the_ledger_of_the_momentum) {
  // Of the directions of space those that no vector of the Lagrangian breaks: three shifts and a turn about
  // the vertical; of the ball on the table all.
  struct Case {
    char const *name, *method;
    std::size_t components;
  };
  for (auto const& [name, method, components] :
       {Case{"rattleback", "natural_chart", 3}, Case{"falling_disc", "cayley_chart", 4},
        Case{"ball_on_turntable", "natural_chart", 6}, Case{"chaplygin_sleigh", "natural_chart", 3}}) {
    auto const rows = rows_of(name, "[\"momentum_balance\", \"spatial_momentum\"]",
                              {std::string("method.name=") + method, "run.until=2"});
    BOOST_REQUIRE_EQUAL(rows[0].size() - 1 - components, name == std::string("chaplygin_sleigh") ? 3u : 6u);
    double balance = 0, momentum = 0, size = 0;
    for (auto const& row : rows) {
      for (std::size_t i = 1; i <= components; ++i)
        balance = std::max(balance, std::abs(row[i] - rows[0][i]));
      for (std::size_t i = components + 1; i < row.size(); ++i) {
        momentum = std::max(momentum, std::abs(row[i] - rows[0][i]));
        size = std::max(size, std::abs(row[i]));
      }
    }
    BOOST_TEST_MESSAGE(name << ": balance " << balance / size << ", momentum " << momentum / size);
    // Twenty thousand substeps at most, with some ten roundings each that add up like a random walk.
    BOOST_TEST(balance <= 1e-12 * size, name);
    BOOST_TEST(momentum > 0.01 * size, name);
  }
}

BOOST_AUTO_TEST_SUITE_END()
