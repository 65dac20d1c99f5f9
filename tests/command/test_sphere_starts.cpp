// How flows on the sphere begin: named states, files of coefficients, and what is refused.
#include <boost/test/unit_test.hpp>

#include <cmath>
#include <filesystem>

#include "process.hpp"
#include "sphere_scene.hpp"

namespace {

constexpr double pi = 3.14159265358979323846;
using namespace command;

}  // namespace

BOOST_AUTO_TEST_SUITE(sphere_starts)

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
  // A spreadsheet begins its tables with a mark.
  folder.write("start.csv", "\xEF\xBB\xBF" + rows);
  BOOST_TEST((run_in(folder, scene).rows == given.rows));
  folder.write("start.csv", rows);
  run_in(folder, scene);
  // The copy runs from anywhere, and resumes.
  BOOST_TEST(actio({"run", folder / "out/scene.toml", "--out", folder / "again"}).status == 0);
  BOOST_TEST(contents(folder / "again/series.csv") == contents(folder / "out/series.csv"));
  BOOST_TEST(actio({"resume", folder / "out", "--until", "4"}).status == 0);
  folder.write("start.csv", "l,m,re,im\n1,0,0,0\n1,1,0.2,0.1\n");
  auto const changed = actio({"resume", folder / "out", "--until", "6"});
  BOOST_TEST(changed.status == 2);
  BOOST_TEST(changed.err.starts_with(folder / "start.csv" + ": has changed since the scene was read with it"),
             changed.err);

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

// The number is an upper bound: that of the torus as well, which counts the same matrices.
BOOST_AUTO_TEST_CASE(a_run_takes_the_memory_that_was_told_or_a_third_less) {
  for (std::string const precision : {"mixed", "double"})
    for (std::string const method : {"all_invariants", "energy_casimir", "lie_poisson"}) {
      Folder const folder;
      Sphere scene;
      scene.n = "400", scene.method = method, scene.step = "0.0001", scene.until = scene.every = "0.0012";
      std::string const file = folder.write("sphere.toml", scene.text());
      std::vector<std::string> const run{
          "run", file, "--set", "method.precision=" + precision, "--set", "output.error_estimate=false"};
      auto const with = [&run](std::vector<std::string> const& more) {
        auto out = run;
        out.insert(out.end(), more.begin(), more.end());
        return out;
      };
      std::string const plan = actio(with({"--dry-run"})).out, before = "at most about ";
      std::size_t const at = plan.find(before);
      BOOST_REQUIRE_MESSAGE(at != std::string::npos, plan);
      double const told = std::stod(plan.substr(at + before.size())),
                   taken = cost(with({"--quiet", "--out", folder / "out"})).peak_megabytes;
      BOOST_TEST((told >= taken && told <= 1.5 * taken),
                 method << ", " << precision << ": " << told << " MB were told, and " << taken << " taken");
    }
  Folder const folder;
  BOOST_TEST(
      has(actio({"run", folder.write("sphere.toml", Sphere().text()), "--dry-run", "--ranks", "2"}).out,
          "on each of the others"));
}

BOOST_AUTO_TEST_SUITE_END()
