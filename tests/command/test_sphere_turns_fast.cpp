// Flows on spheres that turn fast: what is conserved of them, waves whose motion is known, and the error.
#include <boost/test/unit_test.hpp>

#include <nlohmann/json.hpp>

#include <array>
#include <cmath>
#include <complex>
#include <limits>

#include "sphere_scene.hpp"

namespace {

constexpr double eps = std::numeric_limits<double>::epsilon(), pi = 3.14159265358979323846;
using namespace command;
using nlohmann::json;

std::string text_of(double x) {
  std::ostringstream out;
  out.precision(17);
  out << x;
  return out.str();
}
/// Some waves, on a sphere that turns about `times` as fast as they do, while it turns by `angle`.
Sphere fast(double times, double angle) {
  Sphere scene = starting("harmonics = [[5, 3, 0.2, 0.1], [3, 1, 0.5, 0.0], [1, 0, 0.5, 0.0]]");
  scene.rotation = text_of(times), scene.step = "";
  scene.until = text_of(angle / times), scene.every = text_of(angle / times / 5);
  scene.quantities = "\"energy\", \"enstrophy\", \"angular_momentum\", \"extrema\"";
  return scene;
}
json summary_of(Folder const& folder) { return json::parse(contents(folder / "out/summary.json")); }
/// A coefficient of the last snapshot.
std::complex<double> coefficient(Table const& table, int l, int m) {
  auto const at = static_cast<std::size_t>(l * (l + 1) / 2 + m - 1);
  BOOST_REQUIRE(table.rows.at(at)[0] == l);
  BOOST_REQUIRE(table.rows.at(at)[1] == m);
  return {table.rows[at][2], table.rows[at][3]};
}
/// What is seen at the end of a run with one snapshot there.
Table end_of(Folder const& folder, Sphere scene) {
  scene.more = "snapshots = []\nsnapshot_every = " + scene.until + "\n";
  run_in(folder, scene);
  return read_csv(folder / "out/snapshots/000001.harmonics.csv");
}

using Matrix = std::array<std::array<double, 3>, 3>;
Matrix product(Matrix const& a, Matrix const& b) {
  Matrix c{};
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
      for (int k = 0; k < 3; ++k) c[i][j] += a[i][k] * b[k][j];
  return c;
}
Matrix transposed(Matrix const& a) {
  Matrix t{};
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) t[i][j] = a[j][i];
  return t;
}
/// About a unit vector, by the formula of Rodrigues.
Matrix rotation(std::array<double, 3> const& e, double angle) {
  Matrix const hat{{{0, -e[2], e[1]}, {e[2], 0, -e[0]}, {-e[1], e[0], 0}}}, square = product(hat, hat);
  Matrix r{};
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
      r[i][j] = (i == j) + std::sin(angle) * hat[i][j] + (1 - std::cos(angle)) * square[i][j];
  return r;
}

// Harmonics of degree 1 as r . x, and of degree 2 as x . Qx.
double const k10 = std::sqrt(3 / (4 * pi)), k11 = std::sqrt(3 / (8 * pi)), k20 = std::sqrt(5 / pi) / 4,
             k21 = std::sqrt(15 / (2 * pi)) / 2, k22 = std::sqrt(15 / (2 * pi)) / 4;
Matrix matrix_of(double c20, std::complex<double> c21, std::complex<double> c22) {
  Matrix q{};
  q[0][0] = 2 * k22 * c22.real() - k20 * c20, q[1][1] = -2 * k22 * c22.real() - k20 * c20;
  q[2][2] = 2 * k20 * c20, q[0][1] = q[1][0] = -2 * k22 * c22.imag();
  q[0][2] = q[2][0] = -k21 * c21.real(), q[1][2] = q[2][1] = k21 * c21.imag();
  return q;
}
/// The largest difference from the coefficients of degree 2 of a table.
double off(Table const& table, Matrix const& q) {
  double const c20 = q[2][2] / (2 * k20);
  std::complex<double> const c21{-q[0][2] / k21, q[1][2] / k21},
      c22{(q[0][0] - q[1][1]) / (4 * k22), -q[0][1] / (2 * k22)};
  return std::max({std::abs(coefficient(table, 2, 0) - c20), std::abs(coefficient(table, 2, 1) - c21),
                   std::abs(coefficient(table, 2, 2) - c22)});
}

}  // namespace

BOOST_AUTO_TEST_SUITE(sphere_turns_fast)

BOOST_AUTO_TEST_CASE(each_form_keeps_what_it_claims_at_every_rotation) {
  for (double const times : {1.0, 10.0, 30.0, 100.0, 1e3, 1e4, 1e6})
    for (std::string const method : {"lie_poisson", "energy_casimir", "all_invariants"})
      for (std::string const order : {"2", "4"}) {
        Folder const folder;
        Sphere scene = fast(times, 20);
        scene.method = method, scene.order = order;
        run_in(folder, scene);
        auto const summary = summary_of(folder);
        auto const& drift = summary["drift"];
        // As in the tests of moderate rotation: a rounding of N eps a step at most.
        double const bound = summary["steps"].get<double>() * (order == "4" ? 5 : 1) * 16 * eps;
        // The steps in mixed precision lose as much more as the sphere turns faster than the flow; beyond
        // sixteen times none are made.
        double const loss = times < 5 ? 16 : 1;
        BOOST_TEST_MESSAGE(method << ", order " << order << ", rotation " << times << ": " << summary["steps"]
                                  << " steps, drift " << drift.dump());
        BOOST_TEST(drift["enstrophy"].get<double>() <= loss * bound);
        if (method != "lie_poisson") BOOST_TEST(drift["energy"].get<double>() <= loss * bound);
        // The momentum is told with that of the sphere, whose rounding it has, relative to that of the flow.
        if (method != "energy_casimir")
          BOOST_TEST(drift["angular_momentum"].get<double>() <= bound + 16 * eps * times);
        for (auto const* const name : {"extrema_min", "extrema_max"})
          BOOST_TEST(drift[name].get<double>() <= bound, name);
        double const unit = summary["drift_units"]["angular_momentum"];
        BOOST_TEST(unit < 4);
      }
}

BOOST_AUTO_TEST_CASE(a_wave_goes_with_its_speed) {
  // A degree on its own drifts to the west by 2 rotation/(l (l + 1)).
  for (double const times : {30.0, 100.0, 1e4, 1e6})
    for (std::string const method : {"energy_casimir", "all_invariants"}) {
      Folder const folder;
      Sphere scene = fast(times, 50);
      scene.method = method, scene.initial = "rossby_haurwitz = { order = 1 }";
      auto const end = end_of(folder, scene);
      double const angle = 2 * 50 / 30.0;
      std::complex<double> const found = coefficient(end, 5, 1), exact = std::polar(1.0, angle);
      BOOST_TEST_MESSAGE(method << ", rotation " << times << ": " << std::abs(found - exact));
      // Angles of 50 are multiplied, and rounded; each of some 150 steps rounds N terms.
      BOOST_TEST(std::abs(found - exact) <= 150 * 16 * eps);
    }
}

BOOST_AUTO_TEST_CASE(beside_a_rotation_about_another_axis_a_wave_is_seen_where_it_is) {
  // The fluid turns as a whole, about an axis that is not the pole, and carries a wave of degree 2: about
  // that axis the wave turns by w/2 - w/6, where w is the vorticity at its end.
  double const spin = 3, c20 = 0.02, time = 2;
  std::complex<double> const c11{-0.8, 0.5}, c21{0.01, -0.03}, c22{0.02, 0.01};
  Folder const folder;
  Sphere scene =
      starting("harmonics = [[1, 1, -0.8, 0.5], [2, 0, 0.02, 0], [2, 1, 0.01, -0.03], [2, 2, 0.02, 0.01]]");
  scene.rotation = text_of(spin), scene.step = "", scene.until = scene.every = text_of(time);
  auto const end = end_of(folder, scene);
  std::array<double, 3> axis{-2 * k11 * c11.real(), 2 * k11 * c11.imag(), 2 * spin};
  double const w = std::hypot(axis[0], axis[1], axis[2]);
  for (double& e : axis) e /= w;
  Matrix const turn = product(rotation({0, 0, 1}, -spin * time), rotation(axis, w / 3 * time));
  Matrix const q = product(product(turn, matrix_of(c20, c21, c22)), transposed(turn));
  BOOST_TEST(off(end, q) <= 1e-13);
  // The rotation beside the sphere's own stays where it is among the stars.
  BOOST_TEST(std::abs(coefficient(end, 1, 1) - c11 * std::polar(1.0, spin * time)) <= 1e-13);
  // What is seen is what moves.
  BOOST_TEST(off(end, matrix_of(c20, c21, c22)) > 1e-2);
  auto const summary = summary_of(folder);
  BOOST_TEST(has(summary["remarks"].dump(), "what turns as a whole has"), summary["remarks"].dump());
}

BOOST_AUTO_TEST_CASE(the_error_is_that_of_the_flow) {
  for (double const times : {1.0, 10.0, 100.0}) {
    Folder const folder;
    Sphere scene = fast(times, 20);
    scene.quantities = "\"energy\"";
    auto const error_of = [&](std::string const& step, Table& end) {
      Sphere one = scene;
      one.step = step;
      one.more = "error_estimate = true\n";
      std::string const until = one.until;
      one.more += "snapshots = []\nsnapshot_every = " + until + "\n";
      run_in(folder, one);
      end = read_csv(folder / "out/snapshots/000001.harmonics.csv");
      return summary_of(folder)["error"];
    };
    Table coarse, fine;
    auto const claimed = error_of(text_of(20 / times / 200), coarse);
    error_of(text_of(20 / times / 3200), fine);
    double square = 0, all = 0;
    for (std::size_t k = 0; k < fine.rows.size(); ++k) {
      double const weight = fine.rows[k][1] == 0 ? 1 : 2;
      for (int part : {2, 3})
        square += weight * std::pow(coarse.rows[k][part] - fine.rows[k][part], 2),
            all += weight * std::pow(fine.rows[k][part], 2);
    }
    double const error = std::sqrt(square / all), told = claimed["vorticity"];
    BOOST_TEST_MESSAGE("rotation " << times << ": error " << error << ", told " << told);
    BOOST_TEST(told <= 3 * error);
    BOOST_TEST(error <= 3 * told);
    BOOST_TEST(!claimed.contains("momentum"));
  }
}

BOOST_AUTO_TEST_CASE(rest_beside_a_fast_sphere_stays_rest) {
  for (std::string const method : {"all_invariants", "energy_casimir", "lie_poisson"}) {
    Folder const folder;
    Sphere scene = fast(1e6, 5);
    scene.method = method, scene.more = "error_estimate = true\n", scene.initial = "harmonics = []";
    auto const table = run_in(folder, scene);
    BOOST_TEST(table["energy"].back() == 0);
    BOOST_TEST(table["enstrophy"].back() == 0);
    auto const summary = summary_of(folder);
    for (auto const& [name, drift] : summary["drift"].items()) BOOST_TEST(drift == 0, name);
    // Nor does a fluid move that turns as a whole about another axis.
    Sphere tilted = fast(1e3, 5);
    tilted.method = method, tilted.initial = "harmonics = [[1, 1, 0.2, 0.1]]";
    auto const turns = run_in(folder, tilted);
    if (method != "energy_casimir")
      BOOST_TEST(std::abs(turns["energy"].back() / turns["energy"].front() - 1) <= 16 * eps);
  }
}

BOOST_AUTO_TEST_CASE(a_run_goes_on_as_if_it_had_not_stopped) {
  Folder const folder;
  Sphere scene = fast(1e3, 20);
  scene.initial = "harmonics = [[1, 1, 3, 1], [3, 1, 0.5, 0], [4, 2, 0.2, 0.1]]";
  auto const whole = run_in(folder, scene);
  std::string const kept = contents(folder / "out/series.csv");
  Sphere half = scene;
  half.until = text_of(8e-3);
  run_in(folder, half);
  BOOST_TEST(actio({"resume", folder / "out", "--until", scene.until}).status == 0);
  BOOST_TEST(contents(folder / "out/series.csv") == kept);
}

BOOST_AUTO_TEST_SUITE_END()
