// Averaged flow on the sphere in scenes: its energy and spectra, its waves, its two vorticities, and what is
// refused.
#include <boost/test/unit_test.hpp>

#include <cmath>
#include <complex>
#include <limits>

#include "sphere_scene.hpp"

namespace {

constexpr double eps = std::numeric_limits<double>::epsilon(), pi = 3.14159265358979323846;
using namespace command;

constexpr double alpha = 0.3;
Sphere averaged(std::string const& metric, std::string const& initial = Sphere().initial) {
  Sphere scene = starting(initial);
  scene.hamiltonian = "averaging = 0.3\nmetric = \"" + metric + "\"\n";
  return scene;
}
double divisor(std::string const& metric, int l) {
  double const y = l * (l + 1.0);
  return y * (1 + alpha * alpha * (metric == "rough" ? y : y - 2));
}

}  // namespace

BOOST_AUTO_TEST_SUITE(sphere_averaged)

BOOST_AUTO_TEST_CASE(its_energy_is_that_of_its_metric) {
  for (std::string const metric : {"deformation", "rough"}) {
    Sphere scene = averaged(metric);
    scene.quantities = "\"energy\", \"spectrum\", \"velocity_spectrum\", \"enstrophy_spectrum\"";
    auto const table = table_of(scene);
    // |f_lm|^2 for m > 0, and half of |f_l0|^2.
    double const squares[] = {0.05, 0.9, 0.125, 0.52};
    double sum = 0;
    for (int l = 1; l <= 4; ++l) {
      double const d = divisor(metric, l), square = squares[l - 1];
      auto const is = [&](std::string const& name, double truth) {
        BOOST_TEST(std::abs(table[name + "_" + std::to_string(l)][0] / truth - 1) <= 256 * eps);
      };
      is("spectrum", square / d), is("enstrophy_spectrum", square);
      is("velocity_spectrum", square * l * (l + 1) / (d * d));
      sum += square / d;
    }
    BOOST_TEST(std::abs(table["energy"][0] / sum - 1) <= 256 * eps);
  }
}

BOOST_AUTO_TEST_CASE(each_form_keeps_of_averaged_flow_what_it_claims) {
  int const steps = 100;
  for (std::string const precision : {"mixed", "double"})
    for (std::string const method : {"lie_poisson", "energy_casimir", "all_invariants"}) {
      Sphere scene = averaged("deformation");
      scene.method = method, scene.until = "5", scene.step = "0.05\nprecision = \"" + precision + "\"";
      scene.quantities = "\"energy\", \"angular_momentum\", \"extrema\", \"spectrum\"";
      auto const table = table_of(scene);
      // As for a layer.
      double const bound = steps * 16 * eps, l = momentum_drift(table), energy = drift(table, "energy");
      if (method == "lie_poisson") BOOST_TEST(energy > 100 * bound);
      if (method != "lie_poisson") BOOST_TEST(energy <= 10 * bound);
      if (method == "energy_casimir") BOOST_TEST(l > bound);
      if (method != "energy_casimir") BOOST_TEST(l <= bound);
      BOOST_TEST(drift(table, "extrema_max") <= 10 * bound);
      BOOST_TEST(drift(table, "spectrum_4") > 0.01);
    }
}

// q = d_1 a x_3 + V relative to the sphere, psi = -a x_3 - V/d_l: V turns by a - (d_1 a + 2 rotation)/d_l.
BOOST_AUTO_TEST_CASE(the_waves_of_averaged_flow_drift_as_they_should) {
  for (std::string const metric : {"deformation", "rough"}) {
    Folder const folder;
    Sphere scene =
        averaged(metric, "rossby_haurwitz = { degree = 3, order = 2, amplitude = 0.5, zonal_rate = 0.3 }");
    scene.n = "12", scene.more = "snapshots = []\nsnapshot_at = [0, 1, 2]\n";
    run_in(folder, scene);
    double const rate = 0.3 - (divisor(metric, 1) * 0.3 + 2 * 0.7) / divisor(metric, 3);
    for (int k = 0; k < 3; ++k) {
      Table const table = read_csv(folder / "out/snapshots/00000" + std::to_string(k) + ".harmonics.csv");
      auto const& row = table.rows.at(3 * 4 / 2 + 2 - 1);
      BOOST_REQUIRE((row[0] == 3 && row[1] == 2));
      // Forty steps in a frame in which nothing moves, for mixed precision to a part of 1e-8 of that.
      BOOST_TEST(std::abs(std::complex(row[2], row[3]) - std::polar(0.5, -2 * rate * k)) <= 40 * 12 * eps);
    }
  }
}

// Of the degree 3 alone q is a multiple of the curl, which is that of the velocity of the scene.
BOOST_AUTO_TEST_CASE(snapshots_have_both_vorticities) {
  for (std::string const metric : {"deformation", "rough"}) {
    Folder const folder;
    Sphere scene = averaged(metric, "harmonics = [[3, 2, 0.4, -0.1]]");
    scene.n = "8", scene.until = "0.05", scene.every = "";
    scene.more = "snapshots = [\"curl\", \"streamfunction\"]\n";
    run_in(folder, scene);
    Table const table = read_csv(folder / "out/snapshots/000000.csv");
    for (std::size_t k = 0; k < table.rows.size(); ++k) {
      BOOST_TEST(std::abs(table["vorticity"][k] - divisor(metric, 3) / 12 * table["curl"][k]) <= 64 * eps);
      BOOST_TEST(std::abs(table["curl"][k] + 12 * table["streamfunction"][k]) <= 64 * eps);
    }
  }
}

BOOST_AUTO_TEST_CASE(a_length_of_zero_is_euler_s_fluid_and_a_short_one_is_told) {
  Sphere euler, zero, short_one;
  for (Sphere* scene : {&euler, &zero, &short_one}) scene->quantities = "\"energy\", \"spectrum\"";
  zero.hamiltonian = "averaging = 0\n", short_one.hamiltonian = "averaging = 0.01\n";
  BOOST_TEST((table_of(euler).rows == table_of(zero).rows));
  Folder const folder;
  run_in(folder, short_one);
  BOOST_TEST(has(contents(folder / "out/summary.json"), "averaging: a length of 0.01 is not resolved"));
  std::string const copy = contents(folder / "out/scene.toml");
  BOOST_TEST(has(copy, "metric = \"deformation\""), copy);
}

BOOST_AUTO_TEST_CASE(what_is_no_averaged_flow_is_refused) {
  Sphere scene;
  auto const with = [&](std::string const& keys, std::string const& says) {
    scene.hamiltonian = keys;
    check_refused(scene, says);
  };
  with("averaging = -0.1\n", "sphere.toml:5:13: averaging: a length in radii of the sphere is expected");
  with("averaging = 0.71\n", "averaging: a length below 0.707107 is expected");
  with("averaging = 1000\nmetric = \"rough\"\n", "averaging: a length below 1000 is expected");
  with("averaging = nan\n", "averaging: a finite number is expected");
  with("averaging = \"0.1\"\n", "averaging: a number is expected");
  with("metric = \"rough\"\n", "metric: it is the metric of averaged flow, whose length is 'averaging'");
  with("averaging = 0.1\nmetric = \"smooth\"\n", "unknown metric 'smooth'");
  with("deformation = 0.4\naveraging = 0.1\n", "averaging: a quasi-geostrophic layer is not averaged");
  with("deformation = 0.4\nmetric = \"rough\"\n", "metric: a quasi-geostrophic layer is not averaged");
}

BOOST_AUTO_TEST_SUITE_END()
