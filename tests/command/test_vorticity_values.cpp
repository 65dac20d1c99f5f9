// The values of the vorticity of flows on the sphere, their histogram, and the canonical splitting.
#include <boost/test/unit_test.hpp>

#include <nlohmann/json.hpp>

#include <cmath>
#include <limits>
#include <numeric>

#include "sphere_scene.hpp"

namespace {

constexpr double eps = std::numeric_limits<double>::epsilon(), pi = 3.14159265358979323846;
using namespace command;
using nlohmann::json;

/// Columns of a list in one row.
std::vector<double> list_of(Table const& table, std::string const& name, int count, std::size_t row) {
  std::vector<double> out;
  for (int k = 1; k <= count; ++k) out.push_back(table[name + "_" + std::to_string(k)][row]);
  return out;
}
double sum_of(std::vector<double> const& numbers) {
  return std::accumulate(numbers.begin(), numbers.end(), 0.0);
}

/// A scene of one rotation about an axis that is not the pole: -iW is c S.e, with N equally spaced values.
Sphere rotation(int n) {
  Sphere scene = starting("harmonics = [[1, 0, 0.3, 0], [1, 1, 0.4, -0.2]]");
  scene.n = std::to_string(n), scene.rotation = "0.0", scene.quantities = "\"histogram\"";
  return scene;
}

}  // namespace

BOOST_AUTO_TEST_SUITE(vorticity_values)

// Traces of powers on one side, powers of eigenvalues on the other: for a flow without a symmetry, for one
// that looks the same after a third of a turn, and for a zonal one.
BOOST_AUTO_TEST_CASE(casimirs_are_the_sums_of_powers_of_the_eigenvalues) {
  int const n = 16;
  for (std::string const initial :
       {"harmonics = [[2, 1, 0.9, -0.3], [3, 0, -0.5, 0], [4, 3, 0.4, 0.6], [1, 1, 0.2, 0.1]]",
        "harmonics = [[4, 3, 0.4, 0.6], [7, 6, 0.5, -0.3], [3, 0, 0.8, 0]]",
        "harmonics = [[1, 0, 0.4, 0], [3, 0, 0.5, 0]]"}) {
    Sphere scene = starting(initial);
    scene.quantities = "\"eigenvalues\", \"casimirs\", \"extrema\"";
    auto const table = table_of(scene);
    for (std::size_t row = 0; row < table.rows.size(); ++row) {
      auto const values = list_of(table, "eigenvalues", n, row);
      BOOST_TEST(std::is_sorted(values.begin(), values.end()));
      BOOST_TEST(values.front() == table["extrema_min"][row]);
      BOOST_TEST(values.back() == table["extrema_max"][row]);
      double const most = std::max(-values.front(), values.back());
      for (int k = 2; k <= 8; ++k) {
        double sum = 0;
        for (double const x : values) sum += std::pow(x, k);
        // Eigenvalues are right to N eps of the largest, and the power k has k times that.
        double const apart = table["casimirs_" + std::to_string(k)][row] - 4 * pi / n * sum;
        BOOST_TEST(std::abs(apart) <= k * n * eps * 4 * pi * std::pow(most, k));
      }
      // 40 steps, each with a rounding of N eps at most.
      for (int k = 1; k <= n; ++k)
        BOOST_TEST(drift(table, "eigenvalues_" + std::to_string(k), most) <= 40 * n * eps);
    }
  }
}

BOOST_AUTO_TEST_CASE(the_histogram_is_that_of_the_eigenvalues) {
  Folder const folder;
  Sphere scene;
  scene.quantities = "\"histogram\", \"eigenvalues\"";
  auto const table = run_in(folder, scene);
  auto const start = list_of(table, "eigenvalues", 16, 0);
  double const width = (start.back() - start.front()) / 32;
  for (std::size_t row = 0; row < table.rows.size(); ++row) {
    std::vector<double> expected(32, 0.0);
    for (double const value : list_of(table, "eigenvalues", 16, row))
      for (std::size_t bin = 0; bin < 32; ++bin) {
        double const low = start.front() + width * static_cast<double>(bin);
        if ((value > low || bin == 0) && (value <= low + width || bin == 31)) {
          expected[bin] += 1.0 / 16;
          break;
        }
      }
    BOOST_TEST((list_of(table, "histogram", 32, row) == expected));
    BOOST_TEST(sum_of(expected) == 1);
  }
  // Where the bins are is told, and the eigenvalues are found once for a row.
  auto const summary = json::parse(contents(folder / "out/summary.json"));
  BOOST_TEST(has(summary["remarks"].dump(), "histogram: 32 bins of the width "));
  BOOST_TEST(summary["evaluations"]["eigenvalues"] == static_cast<int>(table.rows.size()));
  BOOST_TEST(summary["evaluations"]["histogram"] == static_cast<int>(table.rows.size()));
}

// The values of a rotation are equally spaced, (2k - N + 1)/(N - 1) of the greatest: for N = 33 they lie on
// the borders of the bins, whatever rounding makes of them.
BOOST_AUTO_TEST_CASE(the_histogram_of_a_rotation_is_known) {
  for (int const n : {16, 33}) {
    std::vector<double> expected(32, 0.0);
    for (int k = 0; k < n; ++k)
      expected[static_cast<std::size_t>(std::max(0, (32 * k + n - 2) / (n - 1) - 1))] += 1;
    for (double& share : expected) share /= n;
    auto const table = table_of(rotation(n));
    for (std::size_t row = 0; row < table.rows.size(); ++row)
      BOOST_TEST((list_of(table, "histogram", 32, row) == expected), n << ", row " << row);
  }
  // A fluid at rest has one value.
  Sphere rest = rotation(8);
  rest.initial = "harmonics = []";
  BOOST_TEST(table_of(rest)["histogram_1"].back() == 1);
}

BOOST_AUTO_TEST_CASE(enstrophies_of_the_splitting_add_up_and_energies_differ_by_that_of_the_flow) {
  for (std::string const hamiltonian : {"", "deformation = 0.4\n"}) {
    Sphere scene;
    scene.hamiltonian = hamiltonian, scene.quantities = "\"splitting\", \"energy\", \"enstrophy\"";
    auto const table = table_of(scene);
    for (std::size_t row = 0; row < table.rows.size(); ++row) {
      double const energy = table["energy"][row], enstrophy = table["enstrophy"][row];
      // The parts are at right angles, and so are P and the rest, to N eps.
      double const bound = 10 * 16 * eps;
      BOOST_TEST(std::abs(table["splitting_steady_enstrophy"][row] + table["splitting_rest_enstrophy"][row] -
                          enstrophy) <= bound * enstrophy);
      BOOST_TEST(std::abs(table["splitting_steady_energy"][row] - table["splitting_rest_energy"][row] -
                          energy) <= bound * energy);
      BOOST_TEST(table["splitting_rest_enstrophy"][row] > 0.01 * enstrophy);
      BOOST_TEST(table["splitting_steady_enstrophy"][row] > 0.01 * enstrophy);
    }
    // The flow stirs.
    BOOST_TEST(drift(table, "splitting_rest_enstrophy") > 1e-3);
  }
}

// Flows of one degree are steady. A small wave V on a rotation a z is not: W = az + V is a multiple of P and
// (1 - (2 + gamma)/(l (l + 1) + gamma)) V, of which in the second order nothing commutes with P.
BOOST_AUTO_TEST_CASE(the_splitting_of_a_wave_on_a_rotation_is_known) {
  for (double const gamma : {0.0, 6.25}) {
    Sphere scene = starting("harmonics = [[3, 2, 0.4, 0.6], [3, 0, -0.5, 0], [3, 1, 0.2, 0.1]]");
    scene.rotation = "0.0", scene.quantities = "\"splitting\", \"enstrophy\"";
    if (gamma > 0) scene.hamiltonian = "deformation = 0.4\n";
    auto const steady = table_of(scene);
    // Rounding is N eps of W, and enters with its square.
    BOOST_TEST(steady["splitting_rest_enstrophy"][0] <= std::pow(10 * 16 * eps, 2) * steady["enstrophy"][0]);
    scene.initial = "harmonics = [[1, 0, 2, 0], [3, 2, 0.001, 0.002]]";
    double const wave = 5e-6, part = 1 - (2 + gamma) / (12 + gamma);
    auto const table = table_of(scene);
    BOOST_TEST_MESSAGE("rest: " << table["splitting_rest_enstrophy"][0] / (part * part * wave) - 1);
    // Corrections are (0.002/2)^2 times a number of the order of N^0.
    BOOST_TEST(std::abs(table["splitting_rest_enstrophy"][0] / (part * part * wave) - 1) < 1e-4);
    BOOST_TEST(std::abs(table["splitting_rest_energy"][0] / (part * part * wave / (12 + gamma)) - 1) < 1e-4);
  }
}

BOOST_AUTO_TEST_SUITE_END()
