// Scenes of a fluid on the torus: what stays, starts, snapshots, NetCDF, what is refused.
#include <boost/test/unit_test.hpp>

#include <cmath>
#include <filesystem>

#include "command.hpp"

namespace {

using namespace command;

/// A scene, with these lines in its sections.
std::string torus(
    std::string const& system, std::string const& initial, std::string const& more,
    std::string const& output = "quantities = [\"energy\", \"casimirs\", \"eigenvalue_drift\"]\n") {
  return "[system]\nkind = \"vorticity_torus\"\n" + system + "[initial]\n" + initial + more + "[output]\n" +
         output;
}
std::string const ends = "[run]\nuntil = 2\nevery = 0.5\n";

/// The table that a run of it leaves in out/.
Table run_of(Folder const& folder, std::string const& text) {
  folder.write("scene.toml", text);
  auto const ran = actio({"run", folder / "scene.toml", "--out", folder / "out", "--force"});
  BOOST_REQUIRE_MESSAGE(ran.status == 0, ran.err);
  return read_csv(folder / "out/series.csv");
}
/// What is said of a scene that is refused.
std::string said_of(Folder const& folder, std::string const& text) {
  folder.write("scene.toml", text);
  auto const ran = actio({"run", folder / "scene.toml", "--out", folder / "out", "--force"});
  BOOST_TEST(ran.status == 2);
  return ran.err;
}

}  // namespace

BOOST_AUTO_TEST_SUITE(vorticity_torus)

BOOST_AUTO_TEST_CASE(energy_and_casimirs_stay_in_every_precision) {
  Folder const folder;
  for (std::string const precision : {"mixed", "double"})
    for (std::string const system : {"N = 21\n", "N = 21\ndeformation = 0.3\n"}) {
      Table const rows = run_of(folder, torus(system, "random = { first = 1, last = 6 }\n",
                                              "[method]\nprecision = \"" + precision + "\"\n" + ends));
      auto const energy = rows["energy"];
      for (double const e : energy) BOOST_TEST(std::abs(e / energy.front() - 1) <= 1e-12);
      BOOST_TEST(std::abs(energy.front() - 1) <= 1e-12);
      BOOST_TEST(rows["eigenvalue_drift"].back() <= 1e-13);
    }
}

BOOST_AUTO_TEST_CASE(flows_of_one_eigenvalue_stand_still_and_the_mean_is_left_out) {
  Folder const folder;
  std::string const output =
      "quantities = [\"energy\", \"enstrophy\"]\nsnapshots = [\"u\", \"v\", \"streamfunction\"]\n";
  run_of(folder, torus("N = 15\n", "vorticity = \"1 + 2*cos(x)*cos(y)\"\n",
                       "[method]\nprecision = \"double\"\n" + ends, output));
  Table const first = read_csv(folder / "out/snapshots/000000.csv"),
              last = read_csv(folder / "out/snapshots/000001.csv");
  BOOST_TEST((first.columns == std::vector<std::string>{"x", "y", "vorticity", "streamfunction", "u", "v"}));
  BOOST_REQUIRE(first.rows.size() == 225 && last.rows.size() == 225);
  double const eigenvalue = -2 * std::pow(15 / M_PI * std::sin(M_PI / 15), 2);
  for (std::size_t k = 0; k < first.rows.size(); ++k) {
    double const x = first["x"][k], y = first["y"][k], psi = 2 * std::cos(x) * std::cos(y) / eigenvalue;
    BOOST_TEST(std::abs(first["vorticity"][k] - 2 * std::cos(x) * std::cos(y)) <= 1e-13);
    BOOST_TEST(std::abs(last["vorticity"][k] - first["vorticity"][k]) <= 1e-13);
    BOOST_TEST(std::abs(first["streamfunction"][k] - psi) <= 1e-13);
    BOOST_TEST(std::abs(first["u"][k] - 2 * std::cos(x) * std::sin(y) / eigenvalue) <= 1e-13);
    BOOST_TEST(std::abs(first["v"][k] + 2 * std::sin(x) * std::cos(y) / eigenvalue) <= 1e-13);
  }
}

BOOST_AUTO_TEST_CASE(a_run_begins_from_a_snapshot_of_another) {
  Folder const folder;
  std::string const output = "quantities = [\"energy\"]\nsnapshots = []\nsnapshot_at = [1, 2]\n",
                    method = "[method]\nprecision = \"double\"\nstep = 0.02\n";
  Table const whole = run_of(folder, torus("N = 17\n", "state = \"shear_layers\"\n", method + ends, output));
  std::filesystem::copy(folder / "out/snapshots/000000.harmonics.csv", folder / "start.csv");
  std::filesystem::copy(folder / "out/snapshots/000001.csv", folder / "whole.csv");
  run_of(folder, torus("N = 17\n", "file = \"start.csv\"\n", method + "[run]\nuntil = 1\n",
                       "quantities = [\"energy\"]\nsnapshots = []\n"));
  Table const one = read_csv(folder / "whole.csv"), other = read_csv(folder / "out/snapshots/000001.csv");
  for (std::size_t k = 0; k < one.rows.size(); ++k)
    BOOST_TEST(std::abs(one["vorticity"][k] - other["vorticity"][k]) <= 1e-11);
}

BOOST_AUTO_TEST_CASE(fields_go_to_netcdf_and_pictures_are_drawn) {
  Folder const folder;
  run_of(folder,
         torus("N = 9\n", "state = \"taylor_green\"\n", ends,
               "quantities = [\"energy\"]\nformats = [\"csv\", \"netcdf\"]\nsnapshots = []\nplots = true\n"));
  std::string const file = folder / "out/snapshots/fields.nc", head = shell("h5dump -A " + file).out;
  for (char const* words : {"CF-1.10", "vorticity_torus", "streamfunction", "DATASET \"u\"", "( 2, 9, 9 )"})
    BOOST_TEST(head.find(words) != std::string::npos, words);
  BOOST_TEST(contents(folder / "out/plots/vorticity.svg").find("</svg>") != std::string::npos);
  BOOST_TEST(contents(folder / "out/plots/index.html").find("\"flat\":true") != std::string::npos);
}

// The flow of a seed is the same one for every N.
BOOST_AUTO_TEST_CASE(random_flows_do_not_depend_on_the_size) {
  Folder const folder;
  std::string const output = "quantities = [\"energy\"]\nsnapshots = []\nsnapshot_at = [0]\n";
  auto const ratio = [&](std::string const& n) {
    run_of(folder, torus("N = " + n + "\n", "random = { last = 3 }\n", "[run]\nuntil = 0.1\n", output));
    Table const f = read_csv(folder / "out/snapshots/000000.harmonics.csv");
    double one = 0, other = 0;
    for (std::size_t k = 0; k < f.rows.size(); ++k) {
      if (f["m"][k] == 1 && f["n"][k] == 2) one = f["re"][k];
      if (f["m"][k] == 2 && f["n"][k] == 1) other = f["re"][k];
    }
    return one / other;
  };
  // Those of one eigenvalue of the Laplacian.
  double const small = ratio("9"), large = ratio("21");
  BOOST_TEST(std::abs(small / large - 1) <= 1e-12);
}

BOOST_AUTO_TEST_CASE(what_is_no_flow_is_refused_in_words) {
  Folder const folder;
  auto const check = [&](std::string const& system, std::string const& initial, std::string const& words) {
    std::string const said = said_of(folder, torus(system, initial, ends));
    BOOST_TEST(said.find(words) != std::string::npos, "expected '" << words << "', found '" << said << "'");
  };
  check("N = 16\n", "state = \"random\"\n", "N: an odd number is expected, 15 or 17, found 16");
  check("N = 9\n", "", "[initial] needs 'vorticity', a formula in x and y");
  check("N = 9\n", "state = \"random\"\nvorticity = \"sin(x)\"\n", "one of them says how the flow begins");
  check("N = 9\n", "vorticity = \"1/sin(x)\"\n", "a finite number is expected, found inf at x = 0");
  check("N = 9\n", "vorticity = \"sin(z)\"\n", "z");
  check("N = 9\ndeformation = 0\n", "state = \"random\"\n",
        "a radius from 0.001 to 1000 is expected, found 0");
  check("N = 9\n", "taylor_green = { wave_number = 5 }\n", "with N = 9 they go up to 4");
  check("N = 9\n", "random = { first = 4, last = 3 }\n", "first");
  check("N = 9\n", "random = { energy = -1 }\n", "a number >= 0 is expected, found -1");
  check("N = 9\n", "shear_layers = { width = 2 }\n", "a width from 0.01 to 1 is expected, found 2");
  folder.write("bad.csv", "m,n,re,im\n1,0,0.5,0\n1,0,0.5,0\n");
  check("N = 9\n", "file = \"bad.csv\"\n", "the row of m = 1, n = 0 is there twice, first as line 2");
  folder.write("bad.csv", "m,n,re,im\n7,0,0.5,0\n");
  check("N = 9\n", "file = \"bad.csv\"\n", "with N = 9 they go from -4 to 4");
  folder.write("bad.csv", "m,n,re,im\n-1,0,0.5,0\n");
  check("N = 9\n", "file = \"bad.csv\"\n", "rows have n > 0, or n = 0 and m > 0");
}

BOOST_AUTO_TEST_SUITE_END()
