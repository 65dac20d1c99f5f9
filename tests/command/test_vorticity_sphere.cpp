// Flows on the sphere from scenes: what they keep, the wave whose motion is known, frames, and how they are
// stepped.
#include <boost/test/unit_test.hpp>

#include <nlohmann/json.hpp>

#include <cmath>
#include <limits>

#include "sphere_scene.hpp"

namespace {

constexpr double eps = std::numeric_limits<double>::epsilon(), pi = 3.14159265358979323846;
using namespace command;
using nlohmann::json;

}  // namespace

BOOST_AUTO_TEST_SUITE(vorticity_sphere)

BOOST_AUTO_TEST_CASE(each_form_keeps_what_it_claims) {
  int const steps = 400;
  for (std::string const order : {"2", "4"})
    for (std::string const method : {"lie_poisson", "energy_casimir", "all_invariants"}) {
      Sphere scene;
      scene.method = method, scene.order = order, scene.until = "20", scene.every = "1";
      scene.quantities = "\"energy\", \"enstrophy\", \"angular_momentum\", \"casimirs\", \"extrema\"";
      auto const table = table_of(scene);
      // A step leaves a rounding of its own in each invariant, N eps at most of one that is a sum over N
      // numbers; were all of one sign they would add up to this. The power k has k times that of the
      // vorticity.
      double const bound = steps * (order == "4" ? 5 : 1) * 16 * eps;
      double casimirs = 0;
      for (int k = 2; k <= 8; ++k) {
        double const rms = table["casimirs_2"][0] / (4 * pi);
        double const found = drift(table, "casimirs_" + std::to_string(k), 4 * pi * std::pow(rms, 0.5 * k));
        casimirs = std::max(casimirs, found / k);
      }
      double const most = std::max(std::abs(table["extrema_min"][0]), table["extrema_max"][0]);
      double const energy = drift(table, "energy"), l = momentum_drift(table);
      BOOST_TEST_MESSAGE(method << ", order " << order << ", " << steps << " steps: Casimirs " << casimirs
                                << ", energy " << energy << ", angular momentum " << l);
      // (The greatest power is up to so many times that of the root of the mean square.)
      BOOST_TEST(casimirs <= 100 * bound);
      BOOST_TEST(drift(table, "extrema_min", most) <= bound);
      BOOST_TEST(drift(table, "extrema_max", most) <= bound);
      // What is not claimed moves: these comparisons can fail.
      if (method == "all_invariants") BOOST_TEST(energy <= bound);
      if (method == "lie_poisson") BOOST_TEST(energy > 100 * bound);
      if (method == "energy_casimir") {
        // The angular momentum is not along the pole, about which alone it stays.
        BOOST_TEST(l > bound);
        BOOST_TEST(energy <= 10 * bound);
        BOOST_TEST(drift(table, "angular_momentum_z", momentum(table, 0)) <= bound);
        Sphere still = scene;
        still.rotation = "0.0";
        BOOST_TEST(drift(table_of(still), "energy") <= bound);
      } else {
        BOOST_TEST(l <= bound);
      }
      // What is relative differs from what is absolute by multiples of the angular momentum about the pole.
      BOOST_TEST(drift(table, "enstrophy") <= 10 * bound);
    }
}

BOOST_AUTO_TEST_CASE(the_drift_of_the_summary_is_that_of_the_table) {
  Folder const folder;
  Sphere scene;
  scene.quantities = "\"energy\", \"angular_momentum\", \"spectrum\"";
  auto const table = run_in(folder, scene);
  auto const summary = json::parse(contents(folder / "out/summary.json"));
  BOOST_TEST(summary["drift"].size() == 2u);
  BOOST_TEST(summary["drift"]["energy"].get<double>() == drift(table, "energy"));
  BOOST_TEST(summary["drift"]["angular_momentum"].get<double>() <= 1e-13);
  // What was not asked for was not computed.
  for (char const* name :
       {"casimirs", "eigenvalues", "extrema", "histogram", "enstrophy", "enstrophy_spectrum", "splitting"}) {
    BOOST_TEST(summary["evaluations"][name] == 0);
    BOOST_TEST(has(summary["skipped"].dump(), std::string("\"") + name + "\""));
  }
  BOOST_TEST(summary["evaluations"]["spectrum"] == static_cast<int>(table.rows.size()));
  bool told = false;
  for (auto const& remark : summary["remarks"])
    told = told || has(remark, "resolution: the energy, a rigid rotation aside, is around the degree");
  BOOST_TEST(told);
}

BOOST_AUTO_TEST_CASE(spectra_add_up_to_energy_and_enstrophy) {
  Sphere scene;
  scene.quantities = "\"energy\", \"enstrophy\", \"spectrum\", \"enstrophy_spectrum\"";
  auto const table = table_of(scene);
  for (std::size_t row = 0; row < table.rows.size(); ++row) {
    double energy = 0, enstrophy = 0;
    for (int l = 1; l < 16; ++l) {
      double const e = table["spectrum_" + std::to_string(l)][row],
                   z = table["enstrophy_spectrum_" + std::to_string(l)][row];
      energy += e, enstrophy += z;
      BOOST_TEST(std::abs(z - l * (l + 1) * e) <= 8 * eps * z);
    }
    // Transforms of size N have an error of some N eps.
    BOOST_TEST(std::abs(energy / table["energy"][row] - 1) <= 16 * 16 * eps);
    BOOST_TEST(std::abs(enstrophy / table["enstrophy"][row] - 1) <= 16 * 16 * eps);
  }
  // At the start they are those of the coefficients: |0.9 - 0.3i|^2 twice, and so on.
  BOOST_TEST(std::abs(table["spectrum_2"][0] / (0.9 / 6) - 1) <= 256 * eps);
  BOOST_TEST(std::abs(table["spectrum_3"][0] / (0.25 / 24) - 1) <= 256 * eps);
  BOOST_TEST(std::abs(table["spectrum_4"][0] / (0.52 / 20) - 1) <= 256 * eps);
  BOOST_TEST(table["spectrum_5"][0] < 1e-25);
  // The flow moves, and energy goes to other degrees.
  BOOST_TEST(table["spectrum_5"].back() > 1e-6);
}

BOOST_AUTO_TEST_CASE(a_rotating_sphere_is_a_rotating_fluid) {
  // Relative to a sphere that turns by 0.7 the fluid has 2 * 0.7 cos(theta) less: Y_10 sqrt(4 pi/3) is
  // cos(theta).
  Sphere turning, still;
  std::ostringstream row;
  row.precision(17);
  row << ", [1, 0, " << 2 * 0.7 * std::sqrt(4 * pi / 3) << ", 0]]";
  still.rotation = "0.0", still.initial.back() = ' ', still.initial += row.str();
  for (Sphere* scene : {&turning, &still})
    scene->quantities = "\"angular_momentum\", \"casimirs\", \"spectrum\", \"energy\"", scene->until = "10";
  auto const a = table_of(turning), b = table_of(still);
  BOOST_REQUIRE(a.rows.size() == b.rows.size());
  // 200 steps that start from numbers that differ by roundings, which shear draws apart linearly.
  double const bound = 200 * 16 * 16 * eps;
  for (std::size_t k = 0; k < a.rows.size(); ++k) {
    for (char const* name : {"angular_momentum_x", "angular_momentum_y", "angular_momentum_z"})
      BOOST_TEST(std::abs(a[name][k] - b[name][k]) <= bound * momentum(a, 0));
    for (int l = 2; l < 16; ++l) {
      std::string const name = "spectrum_" + std::to_string(l);
      BOOST_TEST(std::abs(a[name][k] - b[name][k]) <= bound * b["energy"][0]);
    }
    BOOST_TEST(std::abs(a["casimirs_4"][k] / b["casimirs_4"][k] - 1) <= bound);
  }
  // 8 pi/3 times the rotation is that of the sphere's own.
  BOOST_TEST(std::abs(a["angular_momentum_z"][0] - 8 * pi / 3 * 0.7) <= bound);
}

BOOST_AUTO_TEST_CASE(methods_have_the_order_that_they_say) {
  Sphere scene;
  scene.until = "2", scene.every = "2", scene.quantities = "\"spectrum\"";
  scene.order = "4", scene.step = "0.0125";
  auto const reference = table_of(scene).rows.back();
  for (std::string const method : {"lie_poisson", "energy_casimir", "all_invariants"})
    for (std::string const order : {"2", "4"}) {
      scene.method = method, scene.order = order;
      double error[2];
      for (int k : {0, 1}) {
        scene.step = k ? "0.1" : "0.2";
        auto const row = table_of(scene).rows.back();
        error[k] = 0;
        for (std::size_t i = 1; i < row.size(); ++i) error[k] += std::pow(row[i] - reference[i], 2);
        error[k] = std::sqrt(error[k]);
      }
      double const found = std::log2(error[0] / error[1]);
      BOOST_TEST_MESSAGE(method << ", order " << order << ": " << error[0] << ", " << error[1] << ", order "
                                << found);
      // The next term is of relative size h^2, of both errors together less than a third of an order.
      BOOST_TEST(std::abs(found - std::stod(order)) < 0.35);
    }
}

BOOST_AUTO_TEST_CASE(a_step_beyond_the_iteration_is_refused_with_one_that_does) {
  for (std::string const order : {"2", "4"}) {
    Folder const folder;
    Sphere scene;
    scene.order = order, scene.step = "20", scene.until = "20", scene.every = "20";
    auto const outcome = actio({"run", folder.write("sphere.toml", scene.text())});
    BOOST_TEST(outcome.status == 3, outcome.err);
    BOOST_TEST(has(outcome.err,
                   "sphere.toml:8:8: step: the iteration of a step of length 20 does not "
                   "contract; the longest that would do is "),
               outcome.err);
    std::string const said = "; the largest that meets the rows is ";
    auto const at = outcome.err.find(said);
    BOOST_REQUIRE(at != std::string::npos);
    auto const number = outcome.err.substr(at + said.size(), outcome.err.find('\n', at) - at - said.size());
    auto const again = actio({"run", folder / "sphere.toml", "--set", "method.step=" + number});
    BOOST_TEST(again.status == 0, again.err);
  }
}

BOOST_AUTO_TEST_CASE(the_smallest_spheres_and_a_fluid_at_rest_run) {
  Sphere scene;
  scene.quantities = "\"energy\", \"angular_momentum\", \"casimirs\", \"extrema\", \"spectrum\"";
  scene.step = "", scene.until = "3", scene.every = "1";
  for (auto const& [n, initial] :
       std::map<std::string, std::string>{{"2", "harmonics = [[1, 1, 0.2, 0.1], [1, 0, 0.5, 0]]"},
                                          {"3", "harmonics = [[1, 1, 0.2, 0.1], [2, 1, 0.5, 0]]"},
                                          {"4", "harmonics = []"}})
    for (std::string const method : {"all_invariants", "energy_casimir", "lie_poisson"})
      for (std::string const rotation : {"0.0", "0.7"}) {
        scene.n = n, scene.initial = initial, scene.method = method, scene.rotation = rotation;
        auto const table = table_of(scene);
        // A rigid rotation about any axis stays as it is: N = 2 knows no other flow.
        if (n == "2") BOOST_TEST(drift(table, "spectrum_1") < 1e-14);
        // Beside a sphere that turns rest is a difference: in each of some ten steps a rounding of N eps.
        if (n == "4") BOOST_TEST(table["energy"].back() <= (rotation == "0.0" ? 0 : std::pow(40 * eps, 2)));
      }
}

BOOST_AUTO_TEST_CASE(rows_between_steps_are_those_of_a_shorter_step) {
  Sphere scene;
  scene.every = "0.03", scene.until = "0.3", scene.step = "0.1";
  check_refused(scene, "rows are at multiples of the step");
  Folder const folder;
  scene.quantities = "\"energy\", \"angular_momentum\", \"spectrum\"";
  auto const between = run_in(folder, scene, {"--set", "run.between_steps=true"});
  scene.step = "0.03";
  auto const met = table_of(scene);
  BOOST_REQUIRE(between.rows.size() == met.rows.size());
  BOOST_TEST(drift(between, "energy") <= 1e-14);
  BOOST_TEST(momentum_drift(between) <= 1e-14);
  // Errors of order 2 of both, (0.1)^2 and a third of the time of turning.
  for (std::size_t k = 0; k < met.rows.size(); ++k)
    BOOST_TEST(std::abs(between["spectrum_3"][k] - met["spectrum_3"][k]) <= 1e-3 * met["energy"][0]);
}

BOOST_AUTO_TEST_CASE(the_default_step_divides_the_rows_and_is_written_back) {
  Folder const folder;
  Sphere scene;
  scene.step = "", scene.n = "32", scene.every = "0.5";
  auto const table = run_in(folder, scene);
  BOOST_TEST(drift(table, "energy") < 1e-13);
  std::string const copy = contents(folder / "out/scene.toml");
  auto const at = copy.find("\nstep = ");
  BOOST_REQUIRE(at != std::string::npos);
  double const step = std::stod(copy.substr(at + 8));
  BOOST_TEST(std::abs(0.5 / step - std::round(0.5 / step)) < 1e-9);
  BOOST_TEST(step < 0.5);
  BOOST_TEST(actio({"run", folder / "out/scene.toml", "--out", folder / "again"}).status == 0);
  BOOST_TEST(contents(folder / "again/series.csv") == contents(folder / "out/series.csv"));
}

BOOST_AUTO_TEST_CASE(the_error_is_estimated_where_that_is_asked_for) {
  Folder const folder;
  Sphere scene;
  run_in(folder, scene);
  auto const without = json::parse(contents(folder / "out/summary.json"));
  BOOST_TEST(has(without["error"]["how"], "costs more than a third"));
  scene.more = "error_estimate = true\n";
  run_in(folder, scene);
  auto const with = json::parse(contents(folder / "out/summary.json"));
  BOOST_TEST(has(with["error"]["how"], "estimated from companion runs"));
  double const error = with["error"]["vorticity"];
  BOOST_TEST(error > 1e-6);
  BOOST_TEST(error < 1e-1);
}

BOOST_AUTO_TEST_CASE(a_sweep_goes_over_numbers_of_the_start_and_of_the_method) {
  Folder const folder;
  Sphere scene = starting("random = { lmax = 4 }");
  scene.until = "0.5", scene.every = "";
  std::string const path = folder.write("sphere.toml", scene.text());
  auto const outcome = actio({"sweep", path, "--over", "initial.random.slope=0,-2", "--over",
                              "method.name=all_invariants,lie_poisson", "--out", folder / "swept"});
  BOOST_TEST(outcome.status == 0, outcome.err);
  BOOST_TEST(has(contents(folder / "swept/sweep.csv"), "initial.random.slope"), outcome.out);
}

BOOST_AUTO_TEST_SUITE_END()
