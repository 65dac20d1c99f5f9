// The incompressible fluid on the sphere through the command: exact flows, what is conserved, bad input.
#include <array>
#include <cmath>
#include <fstream>

#include "medium_scene.hpp"

namespace {

using namespace command;
using Vector = std::array<double, 3>;

Vector cross(Vector const& a, Vector const& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
double dot(Vector const& a, Vector const& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
/// Turned about the axis of w by |w| times t.
Vector turned(Vector const& x, Vector const& w, double t) {
  double const rate = std::sqrt(dot(w, w)), c = std::cos(rate * t), s = std::sin(rate * t);
  Vector const k{w[0] / rate, w[1] / rate, w[2] / rate}, across = cross(k, x);
  double const along = dot(k, x) * (1 - c);
  return {c * x[0] + s * across[0] + along * k[0], c * x[1] + s * across[1] + along * k[1],
          c * x[2] + s * across[2] + along * k[2]};
}

/// A scene of a unit of time with so many cells along an edge, whose steps are in proportion to them.
std::string scene(int cells, std::string const& start, std::string const& more = "") {
  return "[system]\nkind = \"fluid_on_sphere\"\nmesh = { cells = " + std::to_string(cells) +
         " }\n[initial]\n" + start + "\n[method]\nstep = " + std::to_string(0.25 / cells) +
         "\n[run]\nuntil = 1\nevery = 0.25\n[output]\n"
         "quantities = [\"energy\", \"angular_momentum\", \"volume_defect\", \"min_jacobian\"]\n"
         "snapshots = [\"pressure\"]\n" +
         more;
}
Outcome run(Folder const& folder, std::string const& text) {
  auto const outcome = actio({"run", folder.write("sphere.toml", text), "--out", folder / "out", "--force"});
  BOOST_REQUIRE_MESSAGE(outcome.status == 0, outcome.err);
  return outcome;
}

/// The air turns with this, and the stream function 0.2 x y is carried on it.
constexpr Vector turning{0.3, -0.2, 0.5};
/// Its velocity at t, whose wave turns by a part of the turning.
Vector velocity_of_wave(Vector const& x, double t, double part) {
  Vector const X = turned(x, turning, -part * t),
               slope = turned({0.2 * X[1], 0.2 * X[0], 0}, turning, part * t);
  return cross(x, {slope[0] - turning[0], slope[1] - turning[1], slope[2] - turning[2]});
}

/// The root of the mean square of what the last snapshot differs by from `exact(row)`.
template <class Exact>
double mean_error(Table const& nodes, std::vector<std::string> const& columns, Exact const& exact) {
  double sum = 0;
  for (std::size_t k = 0; k < nodes.rows.size(); ++k) {
    auto const there = exact(Vector{nodes["x"][k], nodes["y"][k], nodes["z"][k]});
    for (std::size_t a = 0; a < columns.size(); ++a) sum += std::pow(nodes[columns[a]][k] - there[a], 2);
  }
  return std::sqrt(sum / static_cast<double>(nodes.rows.size()));
}

void check_refused(std::string const& text, int status, std::string const& says) {
  Folder const folder;
  auto const outcome = actio({"run", folder.write("sphere.toml", text), "--dry-run"});
  BOOST_TEST(outcome.status == status, says << "\n" << outcome.err << outcome.out);
  BOOST_TEST(outcome.err.find(says) != std::string::npos,
             "expected '" << says << "', found '" << outcome.err << "'");
}

}  // namespace

BOOST_AUTO_TEST_SUITE(fluid_on_sphere)

BOOST_AUTO_TEST_CASE(a_wave_of_degree_two_on_turning_air_goes_by_two_thirds_of_its_turning) {
  std::string const stream = "stream = \"-(0.3*x - 0.2*y + 0.5*z) + 0.2*x*y\"";
  double errors[2] = {}, other = 0;
  for (int const k : {0, 1}) {
    Folder const folder;
    run(folder, scene(k == 0 ? 4 : 16, stream));
    Table const nodes = read_csv(folder / "out/snapshots/000001.csv");
    auto const error = [&](double part) {
      return mean_error(nodes, {"u", "v", "w"},
                        [&](Vector const& x) { return velocity_of_wave(x, 1, part); });
    };
    errors[k] = error(2.0 / 3), other = error(1);
    Table const rows = read_csv(folder / "out/series.csv");
    double const size = 8.0 / 3 * std::acos(-1.0) * std::sqrt(dot(turning, turning));
    for (char const* const axis : {"angular_momentum_x", "angular_momentum_y", "angular_momentum_z"})
      for (double const one : rows[axis]) BOOST_TEST(std::abs(one - rows[axis][0]) <= 1e-13 * size, axis);
    for (double const one : rows["volume_defect"]) BOOST_TEST(one <= 2e-13);
  }
  double const order = std::log2(errors[0] / errors[1]) / 2;
  BOOST_TEST_MESSAGE("wave on turning air: errors of velocity " << errors[0] << " and " << errors[1]
                                                                << ", order " << order);
  BOOST_TEST(order >= 1.75);
  BOOST_TEST(other >= 10 * errors[1]);  // air that carried the wave along with it would be another flow
}

BOOST_AUTO_TEST_CASE(a_steady_flow_of_degree_two_has_its_pressure) {
  double errors[2] = {};
  for (int const k : {0, 1}) {
    Folder const folder;
    run(folder, scene(k == 0 ? 8 : 16, "stream = \"0.2*x*y\""));
    Table const nodes = read_csv(folder / "out/snapshots/000001.csv");
    // Up to a constant -|u|^2/2 - l (l + 1)/2 psi^2.
    auto const exact = [](Vector const& x) {
      double const psi = 0.2 * x[0] * x[1];
      Vector const u = cross(x, {0.2 * x[1], 0.2 * x[0], 0});
      return -dot(u, u) / 2 - 3 * psi * psi;
    };
    double constant = 0;
    for (std::size_t i = 0; i < nodes.rows.size(); ++i)
      constant += (nodes["pressure"][i] - exact({nodes["x"][i], nodes["y"][i], nodes["z"][i]})) /
                  static_cast<double>(nodes.rows.size());
    errors[k] =
        mean_error(nodes, {"pressure"}, [&](Vector const& x) { return std::array{exact(x) + constant}; });
  }
  double const order = std::log2(errors[0] / errors[1]);
  BOOST_TEST_MESSAGE("steady flow on the sphere: errors of pressure " << errors[0] << " and " << errors[1]
                                                                      << ", order " << order);
  BOOST_TEST(order >= 1.75);
}

BOOST_AUTO_TEST_CASE(a_velocity_is_that_of_its_stream_function_and_what_points_outwards_is_told) {
  Folder const folder;
  run(folder, scene(4, "stream = \"-0.5*z + 0.2*x*y\""));
  std::string const series = contents(folder / "out/series.csv");
  auto const told =
      run(folder, scene(4,
                        "velocity = [\"-0.5*y - 0.2*x*z + 0.3*x\", \"0.5*x + 0.2*y*z + 0.3*y\", "
                        "\"0.2*(x^2 - y^2) + 0.3*z\"]"))
          .err;
  BOOST_TEST(
      told.find("initial.velocity: velocities pointed out of the sphere by up to 0.3,") != std::string::npos,
      told);
  Table const rows = read_csv(folder / "out/series.csv");
  std::ofstream(folder / "stream.csv") << series;
  Table const same = read_csv(folder / "stream.csv");
  for (std::size_t k = 0; k < rows.rows.size(); ++k)
    for (std::size_t a = 0; a < 5; ++a)
      BOOST_TEST(std::abs(rows.rows[k][a] - same.rows[k][a]) <= 1e-11, rows.columns[a]);
}

BOOST_AUTO_TEST_CASE(air_at_rest_stays_and_its_drift_is_not_told) {
  Folder const folder;
  run(folder, scene(2, "stream = \"0\""));
  for (double const one : read_csv(folder / "out/series.csv")["energy"]) BOOST_TEST(one <= 1e-30);
  BOOST_TEST(contents(folder / "out/summary.json").find("\"drift\": {}") != std::string::npos);
}

BOOST_AUTO_TEST_CASE(what_is_no_flow_on_the_sphere_is_refused_at_its_place) {
  std::string const good = "stream = \"-z\"";
  check_refused(scene(1, good), 2,
                "sphere.toml:3:18: cells: a whole number from 2 to 128 is expected, found 1");
  check_refused(scene(4, ""), 2, "initial.velocity or initial.stream is needed");
  check_refused(scene(4, good + "\nvelocity = [\"0\", \"0\", \"0\"]"), 2,
                "sphere.toml:5:10: stream: initial.velocity says the same: one of them is enough");
  check_refused(scene(4, "velocity = [\"-y\", \"x\"]"), 2,
                "velocity: three formulas in x, y, z are expected, found 2");
  check_refused(scene(4, "velocity = [\"-y\", \"x\", \"1/x\"]"), 2,
                "velocity: a finite velocity is expected, found inf at x = 0, y = ");
  check_refused(scene(4, "stream = \"log(z)\""), 2, "stream: a finite velocity is expected, found ");
  check_refused(scene(4, "stream = \"abs(z)\""), 2, "sphere.toml:5:11: stream: 'abs' has kinks");
  check_refused(scene(4, "stream = \"Z\""), 2, "unknown name 'Z'; did you mean 'z'?");
  check_refused(scene(4, "stream = \"1e200*z\""), 2, "stream: the largest velocity is 1e+200; ");
  check_refused(scene(2, "stream = \"30*x*y\""), 3, "step: incompressible medium: ");
}

BOOST_AUTO_TEST_SUITE_END()
