// Flows on the sphere from scenes: what they keep, the wave whose motion is known, frames, and what is
// refused.
#include <boost/test/unit_test.hpp>

#include <nlohmann/json.hpp>

#include <cmath>
#include <complex>
#include <fstream>
#include <limits>

#include "sphere_scene.hpp"

namespace {

constexpr double eps = std::numeric_limits<double>::epsilon(), pi = 3.14159265358979323846;
using command::actio, command::contents, command::Folder, command::Sphere, command::Table, command::run_in,
    command::table_of;
using nlohmann::json;

bool has(std::string const& text, std::string const& part) { return text.find(part) != std::string::npos; }

/// How far a column is from its first value, in units of `size`.
double drift(Table const& table, std::string const& column, double size = 0) {
  auto const values = table[column];
  if (size == 0) size = std::abs(values.front());
  double most = 0;
  for (double const x : values) most = std::max(most, std::abs(x - values.front()) / size);
  return most;
}
double momentum(Table const& table, std::size_t row) {
  return std::hypot(table["angular_momentum_x"][row], table["angular_momentum_y"][row],
                    table["angular_momentum_z"][row]);
}
double momentum_drift(Table const& table) {
  double most = 0;
  for (char const* axis : {"x", "y", "z"})
    most = std::max(most, drift(table, std::string("angular_momentum_") + axis, momentum(table, 0)));
  return most;
}

/// What a scene is refused with.
command::Outcome refused(Sphere const& scene, std::vector<std::string> const& more = {}) {
  Folder const folder;
  std::vector<std::string> arguments{"run", folder.write("sphere.toml", scene.text()), "--dry-run"};
  arguments.insert(arguments.end(), more.begin(), more.end());
  return actio(arguments);
}
void check_refused(Sphere const& scene, std::string const& says, int status = 2) {
  auto const outcome = refused(scene);
  BOOST_TEST(outcome.status == status, says << "\n" << outcome.err << outcome.out);
  BOOST_TEST(has(outcome.err, says), "expected '" << says << "', found '" << outcome.err << "'");
}
Sphere starting(std::string const& initial) {
  Sphere scene;
  scene.initial = initial;
  return scene;
}

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
        BOOST_TEST(l > bound);
        // The energy that it keeps is that of the absolute motion.
        Sphere still = scene;
        still.rotation = "0.0";
        BOOST_TEST(drift(table_of(still), "energy") <= bound);
      } else {
        BOOST_TEST(l <= bound);
        // Relative and absolute enstrophy differ by a multiple of the angular momentum about the pole.
        BOOST_TEST(drift(table, "enstrophy") <= 10 * bound);
      }
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
  for (char const* name : {"casimirs", "extrema", "enstrophy", "enstrophy_spectrum"}) {
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

BOOST_AUTO_TEST_CASE(named_states_begin_as_they_say) {
  auto const begin = [](std::string const& initial, std::string const& n = "16") {
    Sphere scene = starting(initial);
    scene.n = n, scene.rotation = "0.0", scene.step = "", scene.until = "0.1", scene.every = "";
    scene.quantities = "\"energy\", \"enstrophy\", \"angular_momentum\", \"spectrum\", \"extrema\"";
    return table_of(scene);
  };
  // 2 a cos(theta), and 8 pi/3 a.
  auto const wave = begin("rossby_haurwitz = { degree = 4, order = 2, amplitude = 0.5, zonal_rate = 0.25 }");
  BOOST_TEST(std::abs(wave["angular_momentum_z"][0] - 8 * pi / 3 * 0.25) < 1e-13);
  BOOST_TEST(std::abs(wave["spectrum_4"][0] - 0.25 / 20) < 1e-14);
  for (int l = 1; l < 16; ++l)
    BOOST_TEST(drift(wave, "spectrum_" + std::to_string(l), wave["energy"][0]) < 1e-13);
  // The integral of (30 K sin cos^4 cos 4 lambda)^2 is 900 K^2 pi 2 B(3/2, 5)/2.
  auto const four = begin("rossby_haurwitz_4 = { amplitude = 0.5, zonal_rate = 0 }");
  double const square = 900 * 0.25 * pi * std::tgamma(1.5) * std::tgamma(5) / std::tgamma(6.5);
  BOOST_TEST(std::abs(four["enstrophy"][0] / (0.5 * square) - 1) < 1e-13);
  auto const random = begin("random = { lmin = 2, lmax = 6, energy = 3 }");
  BOOST_TEST(std::abs(random["energy"][0] / 3 - 1) < 1e-13);
  BOOST_TEST(random["spectrum_7"][0] < 1e-25);
  BOOST_TEST(random["spectrum_1"][0] < 1e-25);
  BOOST_TEST(random["spectrum_6"][0] > 1e-3);
  auto const ring = begin("state = \"ring\"\nring = { degree = 8, enstrophy = 5 }");
  BOOST_TEST(std::abs(ring["enstrophy"][0] / 5 - 1) < 1e-13);
  BOOST_TEST(ring["spectrum_8"][0] > 100 * ring["spectrum_4"][0]);
  // A vortex has the angular momentum of its circulation, at its place, times sqrt((N - 1)/(N + 1)).
  auto const vortex = begin("point_vortices = { rows = [[0.3, 0.5, 2]] }");
  double const size = 2 * std::sqrt(15.0 / 17);
  BOOST_TEST(std::abs(vortex["angular_momentum_x"][0] - size * std::cos(0.5) * std::cos(0.3)) < 1e-13);
  BOOST_TEST(std::abs(vortex["angular_momentum_y"][0] - size * std::cos(0.5) * std::sin(0.3)) < 1e-13);
  BOOST_TEST(std::abs(vortex["angular_momentum_z"][0] - size * std::sin(0.5)) < 1e-13);
  // All of it in one eigenvalue, but for the mean.
  BOOST_TEST(std::abs(vortex["extrema_max"][0] - 2 * 16 / (4 * pi) * (1 - 1.0 / 16)) < 1e-12);
  BOOST_TEST(std::abs(vortex["extrema_min"][0] + 2 / (4 * pi)) < 1e-12);
  // The integral of (s e^((cos - 1)/w^2))^2 less that of the mean.
  auto const blob = begin("blobs = { rows = [[1.0, -0.4, 0.6, 2]] }", "32");
  double const w = 0.36, mean = 2 * w * (1 - std::exp(-2 / w)) / 2;
  BOOST_TEST(std::abs(blob["enstrophy"][0] /
                          (0.5 * (4 * 2 * pi * w / 2 * (1 - std::exp(-4 / w)) - 4 * pi * mean * mean)) -
                      1) < 1e-12);
  // The largest velocity of the jet is 1 in a narrow band: its energy is the integral of half its square.
  auto const jet = begin("zonal_jet = { }", "128");
  double energy = 0;
  double const a = pi / 7, b = 5 * pi / 14;
  for (int k = 1; k < 4000; ++k) {
    double const phi = a + (b - a) * k / 4000,
                 u = std::exp(4 / ((b - a) * (b - a)) + 1 / ((phi - a) * (phi - b)));
    energy += 0.5 * u * u * 2 * pi * std::cos(phi) * (b - a) / 4000;
  }
  // Degrees beyond 127 have a part of it of exp(-sqrt(..)): 1e-8 of the energy is far more.
  BOOST_TEST(std::abs(jet["energy"][0] / energy - 1) < 1e-8);
}

BOOST_AUTO_TEST_CASE(the_seed_says_what_is_random) {
  auto const energies = [](std::string const& more) {
    Folder const folder;
    Sphere scene = starting("state = \"random\"");
    scene.until = "0.1", scene.every = "", scene.step = "", scene.quantities = "\"spectrum\"";
    return run_in(folder, scene, {"--set", more}).rows.front();
  };
  BOOST_TEST((energies("scene.seed=1") == energies("scene.seed=1")));
  BOOST_TEST((energies("scene.seed=1") != energies("scene.seed=2")));
}

BOOST_AUTO_TEST_CASE(a_file_of_coefficients_is_a_scene_with_these_rows) {
  Folder const folder;
  Sphere scene;
  scene.quantities = "\"spectrum\", \"angular_momentum\"";
  std::string const rows = "l,m,re,im\n1,0,0,0\n1,1,0.2,0.1\n2,0,0,0\n2,1,0.9,-0.3\n2,2,0,0\n";
  scene.initial = "harmonics = [[1, 1, 0.2, 0.1], [2, 1, 0.9, -0.3]]";
  auto const given = table_of(scene);
  folder.write("start.csv", rows);
  scene.initial = "file = \"start.csv\"";
  BOOST_TEST((run_in(folder, scene).rows == given.rows));
  // The copy runs from anywhere, and resumes.
  BOOST_TEST(actio({"run", folder / "out/scene.toml", "--out", folder / "again"}).status == 0);
  BOOST_TEST(contents(folder / "again/series.csv") == contents(folder / "out/series.csv"));
  BOOST_TEST(actio({"resume", folder / "out", "--until", "4"}).status == 0);
  folder.write("start.csv", "l,m,re,im\n1,0,0,0\n1,1,0.2,0.1\n");
  auto const changed = actio({"resume", folder / "out", "--until", "6"});
  BOOST_TEST(changed.status == 4);
  BOOST_TEST(has(changed.err, "was changed since"), changed.err);

  auto const with = [&](std::string const& text) {
    folder.write("start.csv", text);
    auto const outcome = actio({"run", folder.write("sphere.toml", scene.text()), "--dry-run"});
    BOOST_TEST(outcome.status == 2, text);
    return outcome.err;
  };
  BOOST_TEST(has(with(rows + "2,1,0.1,0\n"),
                 "start.csv:7:1: the row of l = 2, m = 1 is there twice, first as line 5"));
  BOOST_TEST(has(with("l,m,re,im\n1,0,0,0\n1,1,0.2,0.1\n2,0,0,0\n2,2,0,0\n"),
                 "start.csv:5:1: the row of l = 2, m = 1 is missing; the file goes to the degree 2"));
  BOOST_TEST(has(with("l,m,re,im\n1,0,0,0\n1,1,0.2\n"),
                 "start.csv:3:1: four numbers l,m,re,im are expected, found '1,1,0.2'"));
  BOOST_TEST(has(with("l;m;re;im\n"), "start.csv:1:1: the heading l,m,re,im is expected"));
  BOOST_TEST(has(with(""), "the file is empty"));
  BOOST_TEST(has(with("l,m,re,im\n1,0,0,0\n16,0,0.2,0\n"), "start.csv:3:1: the degree l = 16 is outside"));
  BOOST_TEST(has(with("l,m,re,im\n1,0,0.5,0.1\n"), "start.csv:2:1: a coefficient of order 0 is real"));
  BOOST_TEST(has(with("l,m,re,im\n1,0,nan,0\n"), "start.csv:2:1: four numbers"));
  std::filesystem::remove(folder / "start.csv");
  auto const none = actio({"run", folder / "sphere.toml", "--dry-run"});
  BOOST_TEST(none.status == 2);
  BOOST_TEST(has(none.err, "sphere.toml:15:8: file: "), none.err);
  BOOST_TEST(has(none.err, "there is no such file"), none.err);
}

BOOST_AUTO_TEST_CASE(what_is_no_flow_is_refused_with_its_place) {
  Sphere scene;
  for (auto const& [row, says] : std::map<std::string, std::string>{
           {"[16, 0, 1, 0]",
            "sphere.toml:15:30: harmonics: the degree l = 16 is outside of what matrices of this size "
            "hold: with N = 16 degrees go from 1 to 15"},
           {"[3, -1, 1, 0]", ":15:30: harmonics: the order m = -1 is negative; rows have m >= 0"},
           {"[3, 4, 1, 0]", ":15:30: harmonics: the order m = 4 is greater than the degree l = 3"},
           {"[0, 0, 1, 0]", ":15:30: harmonics: the degree 0 is the mean of the vorticity"},
           {"[3, 0, 1, 0.5]",
            ":15:30: harmonics: a coefficient of order 0 is real, or the field would be complex"},
           {"[2, 1, 1, 0]", ":15:30: harmonics: the row of l = 2, m = 1 is there twice, first as row 1"},
           {"[2.5, 1, 1, 0]", ":15:30: harmonics: degree and order are whole numbers, found l = 2.5, m = 1"},
           {"[2, 1, 1]", ":15:30: harmonics: 4 numbers are expected, found 3"},
           {"[2, 2, inf, 0]", "a finite number is expected, found inf"},
           {"3", "a list of numbers in each row is expected, found 3"}}) {
    scene.initial = "harmonics = [[2, 1, 0.9, 0], " + row + "]";
    check_refused(scene, says);
  }
  check_refused(starting("harmonics = 3"), "a list of rows is expected");
  check_refused(starting(""), "[initial] needs 'harmonics', rows l, m, re, im; or 'file'");
  check_refused(starting("harmonics = []\nstate = \"random\""), "[initial] has 'harmonics' and 'state'");
  check_refused(starting("random = {}\nring = {}"), "[initial] has 'random' and 'ring'");
  check_refused(starting("state = \"random\"\nring = {}"),
                "parameters of another state than state = \"random\"");
  check_refused(starting("state = \"randm\""), "unknown state 'randm'; did you mean 'random'?");
  check_refused(starting("random = { lmx = 3 }"), "did you mean 'lmax'?");
  check_refused(starting("random = 3"), "a table is expected");
  check_refused(starting("random = { lmax = 16 }"), "lmax: the degree 16 is outside");
  check_refused(starting("random = { energy = 1, enstrophy = 1 }"),
                "energy and enstrophy exclude each other");
  check_refused(starting("random = { energy = -1 }"), "energy: a number >= 0 is expected, found -1");
  check_refused(starting("rossby_haurwitz = { degree = 4, order = 5 }"),
                "a whole number from 0 to 4 is expected");
  check_refused(starting("zonal_jet = { south = 1.0, north = 0.9 }"), "north: the jet lies between");
  check_refused(starting("zonal_jet = { north = 90 }"), "a latitude in radians");
  check_refused(starting("blobs = { rows = [[0, 0, 0, 1]] }"), "width in radians");
  check_refused(starting("blobs = { rows = [] }"), "at least one row");
  check_refused(starting("point_vortices = { rows = [[0, 2, 1]] }"), "latitude in radians");
  check_refused(starting("harmonics = [[2, 1, 1e300, 0]]"), "the vorticity is larger than");
  scene = starting("harmonics = [[2, 1, 1e-300, 0]]"), scene.rotation = "0.0";
  check_refused(scene, "the vorticity is smaller than");
  scene = starting("harmonics = [[2, 1, 1e50, 0]]"), scene.quantities = "\"casimirs\"";
  check_refused(scene, "casimirs_8 would be no number");
  for (std::string const n : {"1", "0", "-3"}) {
    scene = Sphere(), scene.n = n;
    check_refused(scene, "sphere.toml:3:5: N: a whole number from 2");
  }
  scene = Sphere(), scene.n = "2.0";
  check_refused(scene, "N: a whole number is expected, found 2.0; write 2");
}

BOOST_AUTO_TEST_CASE(memory_that_is_not_there_is_refused_before_it_is_touched) {
  Sphere scene;
  scene.n = "1000000", scene.step = "";
  auto const outcome = refused(scene);
  BOOST_TEST(outcome.status == 2, outcome.err);
  BOOST_TEST(has(outcome.err, "sphere.toml:3:5: N: matrices of the size 1000000 take about "), outcome.err);
  BOOST_TEST(has(outcome.err, " of memory in this scene, where "), outcome.err);
  // A process that is allowed less has less.
  Folder const folder;
  scene.n = "1500";
  auto const limited =
      actio({"run", folder.write("sphere.toml", scene.text()), "--dry-run"}, "ulimit -v 1000000;");
  BOOST_TEST(limited.status == 2, limited.err);
  BOOST_TEST(has(limited.err, "where 1.02 GB are there"), limited.err);
}

BOOST_AUTO_TEST_CASE(a_step_beyond_the_iteration_is_refused_with_one_that_does) {
  for (std::string const order : {"2", "4"}) {
    Folder const folder;
    Sphere scene;
    scene.order = order, scene.step = "20", scene.until = "20", scene.every = "20";
    auto const outcome = actio({"run", folder.write("sphere.toml", scene.text())});
    BOOST_TEST(outcome.status == 3, outcome.err);
    BOOST_TEST(has(outcome.err,
                   "sphere.toml:8:8: step: the iteration of a step of length 20 does not contract; the "
                   "longest that would do is "),
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
        if (n == "4") BOOST_TEST(table["energy"].back() == 0);
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
  BOOST_TEST(has(with["error"]["how"], "estimated from a companion run"));
  double const error = with["error"]["momentum"];
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
