// Quasi-geostrophic layers on the sphere: their energy, their waves, their velocity, and what is refused.
#include <boost/test/unit_test.hpp>

#include <cmath>
#include <complex>
#include <limits>

#include "sphere_scene.hpp"

namespace {

constexpr double eps = std::numeric_limits<double>::epsilon(), pi = 3.14159265358979323846;
using namespace command;

constexpr double gamma_ = 6.25;  // 1/0.4^2
Sphere layer(std::string const& initial = Sphere().initial) {
  Sphere scene = starting(initial);
  scene.hamiltonian = "hamiltonian = \"quasi_geostrophic\"\ndeformation = 0.4\n";
  return scene;
}
/// A coefficient of a snapshot.
std::complex<double> coefficient(Table const& table, int l, int m) {
  auto const at = static_cast<std::size_t>(l * (l + 1) / 2 + m - 1);
  BOOST_REQUIRE(table.rows.at(at)[0] == l);
  BOOST_REQUIRE(table.rows.at(at)[1] == m);
  return {table.rows[at][2], table.rows[at][3]};
}

}  // namespace

BOOST_AUTO_TEST_SUITE(sphere_layers)

BOOST_AUTO_TEST_CASE(its_energy_has_that_of_the_surface) {
  Sphere scene = layer();
  scene.quantities = "\"energy\", \"spectrum\", \"enstrophy\"";
  auto const table = table_of(scene);
  // |f_lm|^2 for m > 0, and half of |f_l0|^2, over l (l + 1) + gamma.
  double const parts[] = {0.05 / (2 + gamma_), 0.9 / (6 + gamma_), 0.125 / (12 + gamma_),
                          0.52 / (20 + gamma_)};
  double sum = 0;
  for (int l = 1; l <= 4; ++l) {
    BOOST_TEST(std::abs(table["spectrum_" + std::to_string(l)][0] / parts[l - 1] - 1) <= 256 * eps);
    sum += parts[l - 1];
  }
  BOOST_TEST(std::abs(table["energy"][0] / sum - 1) <= 256 * eps);
  BOOST_TEST(std::abs(table["enstrophy"][0] / 1.595 - 1) <= 256 * eps);
}

BOOST_AUTO_TEST_CASE(each_form_keeps_of_it_what_it_claims) {
  int const steps = 100;
  for (std::string const order : {"2", "4"})
    for (std::string const method : {"lie_poisson", "energy_casimir", "all_invariants"}) {
      Sphere scene = layer();
      scene.method = method, scene.order = order, scene.until = "5";
      scene.quantities = "\"energy\", \"enstrophy\", \"angular_momentum\", \"extrema\", \"spectrum\"";
      auto const table = table_of(scene);
      // As for Euler's fluid: N eps a step at most, and what is relative is a tenth of what is absolute.
      double const bound = steps * (order == "4" ? 5 : 1) * 16 * eps;
      double const l = momentum_drift(table), energy = drift(table, "energy");
      BOOST_TEST_MESSAGE(method << ", order " << order << ": energy " << energy << ", angular momentum "
                                << l);
      if (method == "lie_poisson") BOOST_TEST(energy > 100 * bound);
      if (method != "lie_poisson") BOOST_TEST(energy <= 10 * bound);
      if (method == "energy_casimir") BOOST_TEST(l > bound);
      if (method != "energy_casimir") BOOST_TEST(l <= bound);
      BOOST_TEST(drift(table, "angular_momentum_z", momentum(table, 0)) <= bound);
      BOOST_TEST(drift(table, "enstrophy") <= 10 * bound);
      BOOST_TEST(drift(table, "extrema_max") <= 10 * bound);
      BOOST_TEST(drift(table, "spectrum_4") > 0.01);
    }
}

// q = (2 + gamma) a x_3 + V relative to the sphere, psi = -a x_3 - V/(l (l + 1) + gamma): V turns by
// a - ((2 + gamma) a + 2 rotation)/(l (l + 1) + gamma).
BOOST_AUTO_TEST_CASE(its_waves_drift_as_they_should) {
  for (double const gamma : {0.0, gamma_})
    for (std::string const method : {"energy_casimir", "all_invariants"}) {
      Folder const folder;
      Sphere scene = layer("rossby_haurwitz = { degree = 3, order = 2, amplitude = 0.5, zonal_rate = 0.3 }");
      if (gamma == 0) scene.hamiltonian = "";
      scene.n = "12", scene.method = method, scene.more = "snapshots = []\nsnapshot_at = [0, 1, 2]\n";
      run_in(folder, scene);
      double const rate = 0.3 - ((2 + gamma) * 0.3 + 2 * 0.7) / (12 + gamma);
      for (int k = 0; k < 3; ++k) {
        Table const table = read_csv(folder / "out/snapshots/00000" + std::to_string(k) + ".harmonics.csv");
        // Forty steps in a frame in which nothing moves: a rounding of N eps in each.
        BOOST_TEST(std::abs(coefficient(table, 3, 2) - std::polar(0.5, -2 * rate * k)) <= 40 * 12 * eps);
        BOOST_TEST(std::abs(coefficient(table, 1, 0) - (2 + gamma) * 0.3 * std::sqrt(4 * pi / 3)) <=
                   40 * 12 * eps);
      }
    }
}

BOOST_AUTO_TEST_CASE(a_jet_has_the_velocity_of_its_scene_and_another_vorticity) {
  Folder const folder;
  auto const start = [&](Sphere scene) {
    scene.initial = "zonal_jet = { perturbation = 0.2 }";
    scene.n = "24", scene.step = "", scene.until = "0.01", scene.every = "";
    scene.more = "snapshots = [\"u\", \"v\", \"streamfunction\"]\nsymbol = \"weyl\"\n";
    run_in(folder, scene);
    return read_csv(folder / "out/snapshots/000000.csv");
  };
  auto const euler = start(Sphere()), deep = start(layer());
  for (std::size_t k = 0; k < euler.rows.size(); ++k) {
    // Vorticities are about ten, and come through two transforms of size N.
    for (char const* name : {"u", "v", "streamfunction"})
      BOOST_TEST(std::abs(euler[name][k] - deep[name][k]) <= 100 * 24 * eps);
    BOOST_TEST(std::abs(deep["vorticity"][k] - euler["vorticity"][k] + gamma_ * deep["streamfunction"][k]) <=
               100 * 24 * eps);
  }
}

BOOST_AUTO_TEST_CASE(random_flows_have_the_energy_of_their_scene) {
  Sphere scene = layer("random = { lmin = 2, lmax = 6, energy = 3 }");
  scene.quantities = "\"energy\"", scene.step = "", scene.until = "0.1", scene.every = "";
  BOOST_TEST(std::abs(table_of(scene)["energy"][0] / 3 - 1) < 1e-13);
}

// With a radius of deformation of 1000 radii gamma is 1e-6, and the flow is Euler's but for a part of it.
BOOST_AUTO_TEST_CASE(a_deep_layer_flows_as_euler_s_fluid) {
  Sphere euler, deep;
  deep.hamiltonian = "deformation = 1000\n";
  for (Sphere* scene : {&euler, &deep}) scene->quantities = "\"spectrum\", \"angular_momentum\"";
  auto const a = table_of(euler), b = table_of(deep);
  double apart = 0;
  for (std::size_t k = 1; k < a.rows.back().size(); ++k)
    apart = std::max(apart, std::abs(a.rows.back()[k] - b.rows.back()[k]));
  BOOST_TEST(apart <= 1e-5);
  BOOST_TEST(apart > 1e-9);
}

BOOST_AUTO_TEST_CASE(its_steps_are_in_double_precision) {
  Folder const folder;
  run_in(folder, layer());
  std::string const copy = contents(folder / "out/scene.toml");
  BOOST_TEST(has(copy, "precision = \"double\""), copy);
  BOOST_TEST(has(copy, "hamiltonian = \"quasi_geostrophic\""), copy);
  BOOST_TEST(has(contents(folder / "out/summary.json"), "a quasi-geostrophic layer is stepped in double"));
  // A radius of deformation says that there is a layer.
  Sphere scene = layer();
  scene.hamiltonian = "deformation = 0.4\n";
  BOOST_TEST((table_of(scene).rows == read_csv(folder / "out/series.csv").rows));
}

BOOST_AUTO_TEST_CASE(what_is_no_layer_is_refused) {
  Sphere scene;
  auto const with = [&](std::string const& keys, std::string const& says) {
    scene.hamiltonian = keys;
    check_refused(scene, says);
  };
  with("hamiltonian = \"quasi_geostrophic\"\n",
       "sphere.toml:5:15: hamiltonian: a quasi-geostrophic layer needs");
  with("hamiltonian = \"euler\"\ndeformation = 0.4\n",
       "sphere.toml:6:15: deformation: Euler's fluid has no radius of deformation");
  with("hamiltonian = \"eulr\"\n", "unknown Hamiltonian 'eulr'; did you mean 'euler'?");
  for (std::string const radius : {"0", "-0.4", "1e-4", "1001", "1e300"})
    with("deformation = " + radius + "\n",
         "sphere.toml:5:15: deformation: a radius from 0.001 to 1000, in radii of "
         "the sphere, is expected, found ");
  with("deformation = inf\n", "deformation: a finite number is expected");
  with("deformation = \"0.4\"\n", "deformation: a number is expected");
  scene.step = "0.05\nprecision = \"mixed\"";
  with("deformation = 0.4\n", "precision: a quasi-geostrophic layer is stepped in double precision");
}

BOOST_AUTO_TEST_SUITE_END()
