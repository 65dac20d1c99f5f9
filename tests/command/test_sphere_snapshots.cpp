// Snapshots of flows on the sphere: tables, coefficients to begin from, NetCDF, and maps.
#include <boost/test/unit_test.hpp>

#include <cmath>
#include <cstring>
#include <filesystem>

#include "page_in_node.hpp"
#include "sphere_scene.hpp"

namespace {

using namespace command;

constexpr int n = 10;

/// Three of them.
Sphere scene() {
  Sphere out;
  out.n = std::to_string(n);
  out.quantities = "\"energy\", \"extrema\"";
  out.more =
      "formats = [\"csv\", \"netcdf\"]\nsnapshots = [\"u\", \"v\", \"streamfunction\"]\nsnapshot_every = 1\n";
  return out;
}
double largest_difference(std::vector<double> const& a, std::vector<double> const& b) {
  BOOST_REQUIRE(a.size() == b.size());
  double most = 0;
  for (std::size_t i = 0; i < a.size(); ++i) most = std::max(most, std::abs(a[i] - b[i]));
  return most;
}
/// A data set of an HDF5 file, which NetCDF-4 is.
std::vector<double> numbers_of(Folder const& folder, std::string const& path, std::string const& set) {
  auto const told = shell("h5dump -d " + set + " -b LE -o " + folder / "numbers" + " " + path);
  BOOST_REQUIRE_MESSAGE(told.status == 0, told.err);
  std::string const bytes = contents(folder / "numbers");
  std::vector<double> out(bytes.size() / sizeof(double));
  std::memcpy(out.data(), bytes.data(), bytes.size());
  return out;
}
bool installed(std::string const& program) {
  bool const there = shell("command -v " + program).status == 0;
  if (!there) BOOST_TEST_MESSAGE(program << " is not installed, and is not asked");
  return there;
}

}  // namespace

BOOST_AUTO_TEST_SUITE(sphere_snapshots)

BOOST_AUTO_TEST_CASE(tables_hold_fields_and_coefficients) {
  Folder const folder;
  Table const series = run_in(folder, scene());
  std::string const within = folder / "out/snapshots/";
  BOOST_TEST(contents(within + "times.csv") == "snapshot,t\n0,0\n1,1\n2,2\n");
  Table const start = read_csv(within + "000000.harmonics.csv"),
              end = read_csv(within + "000002.harmonics.csv");
  BOOST_TEST((start.columns == std::vector<std::string>{"l", "m", "re", "im"}));
  BOOST_TEST(start.rows.size() == n * (n + 1) / 2 - 1);
  // At the start those of the scene; two transforms of sums of N terms lie between.
  for (auto const& [l, m, re, im] :
       {std::array{2.0, 1.0, 0.9, -0.3}, {3, 0, -0.5, 0}, {4, 3, 0.4, 0.6}, {1, 1, 0.2, 0.1}, {5, 2, 0, 0}})
    for (auto const& row : start.rows)
      if (row[0] == l && row[1] == m) BOOST_TEST(std::hypot(row[2] - re, row[3] - im) <= 1e-14);

  Table const fields = read_csv(within + "000002.csv");
  BOOST_TEST((fields.columns ==
              std::vector<std::string>{"longitude", "latitude", "vorticity", "u", "v", "streamfunction"}));
  BOOST_REQUIRE(fields.rows.size() == 2 * n * n);
  // The symbol of Berezin: b_l = prod sqrt((N - k)/(N + k)) at one place, term by term.
  std::size_t const at = 7 * 2 * n + 3;
  double const longitude = fields["longitude"][at], latitude = fields["latitude"][at];
  double sum = 0;
  for (auto const& row : end.rows) {
    auto const l = static_cast<unsigned>(row[0]), m = static_cast<unsigned>(row[1]);
    double factor = m == 0 ? 1 : 2;
    for (unsigned k = 1; k <= l; ++k) factor *= std::sqrt((n - double(k)) / (n + double(k)));
    // std::sph_legendre has the Condon-Shortley phase.
    double const p = std::sph_legendre(l, m, std::acos(-1.0) / 2 - latitude);
    sum += factor * p * (row[2] * std::cos(m * longitude) - row[3] * std::sin(m * longitude));
  }
  BOOST_TEST(std::abs(fields["vorticity"][at] - sum) <= 1e-13);
  // The values are means of the matrix, in the interval of its eigenvalues.
  for (std::size_t k = 0; k < 3; ++k)
    for (double const value : read_csv(within + "00000" + std::to_string(k) + ".csv")["vorticity"]) {
      BOOST_TEST(value >= series["extrema_min"][2 * k]);
      BOOST_TEST(value <= series["extrema_max"][2 * k]);
    }
  BOOST_TEST(has(contents(folder / "out/scene.toml"), "symbol = \"berezin\""));
  BOOST_TEST(has(contents(folder / "out/summary.json"), "\"snapshots\": 3"));
}

BOOST_AUTO_TEST_CASE(a_run_begins_from_a_snapshot) {
  Folder const folder;
  Sphere first = scene();
  first.more = "snapshots = []\n";
  run_in(folder, first);
  folder.write("from.csv", contents(folder / "out/snapshots/000001.harmonics.csv"));
  Sphere second = first;
  second.initial = "file = \"from.csv\"", second.until = "0.05", second.every = "";
  run_in(folder, second);
  // There and back through the matrix: two transforms of sums of N terms.
  Table const from = read_csv(folder / "from.csv"),
              found = read_csv(folder / "out/snapshots/000000.harmonics.csv");
  BOOST_TEST(largest_difference(from["re"], found["re"]) <= 1e-14);
  BOOST_TEST(largest_difference(from["im"], found["im"]) <= 1e-14);
}

BOOST_AUTO_TEST_CASE(netcdf_holds_the_same_and_opens) {
  Folder const folder;
  run_in(folder, scene());
  std::string const path = folder / "out/snapshots/fields.nc";
  BOOST_TEST((numbers_of(folder, path, "/time") == std::vector<double>{0, 1, 2}));
  for (char const* name : {"vorticity", "streamfunction", "u", "v"}) {
    auto const all = numbers_of(folder, path, std::string("/") + name);
    BOOST_REQUIRE(all.size() == 3 * 2 * n * n);
    for (int k = 0; k < 3; ++k) {
      Table const table = read_csv(folder / "out/snapshots/00000" + std::to_string(k) + ".csv");
      std::vector<double> const one(all.begin() + k * 2 * n * n, all.begin() + (k + 1) * 2 * n * n);
      BOOST_TEST((one == table[name]));
    }
  }
  auto const real = numbers_of(folder, path, "/spectral/vorticity_real");
  Table const last = read_csv(folder / "out/snapshots/000002.harmonics.csv");
  BOOST_TEST(
      (std::vector<double>(real.end() - static_cast<long>(last.rows.size()), real.end()) == last["re"]));
  if (installed("ncdump")) {
    auto const told = shell("ncdump -h " + path);
    BOOST_TEST(told.status == 0);
    for (char const* part : {"Conventions = \"CF-1.10\"", "double vorticity(time, lat, lon)",
                             "group: spectral", "units = \"degrees_north\""})
      BOOST_TEST(has(told.out, part), part);
  }
  if (installed("cdo")) {
    auto const told = shell("cdo sinfo " + path);
    BOOST_TEST(told.status == 0, told.err);
    BOOST_TEST(has(told.out, "gaussian"));
    BOOST_TEST(has(told.out, "3 steps"));
  }
}

// Times without a unit have none in the file either, of which readers would complain; those in seconds have
// dates.
BOOST_AUTO_TEST_CASE(times_have_dates_where_their_unit_is_known) {
  for (bool const known : {false, true}) {
    Folder const folder;
    Sphere timed = scene();
    if (known) timed.more += "[scene]\nunits = { time = \"s\" }\n";
    run_in(folder, timed);
    std::string const path = folder / "out/snapshots/fields.nc";
    auto const time = shell("h5dump -A -d /time " + path), rate = shell("h5dump -A -d /u " + path);
    BOOST_REQUIRE(time.status == 0);
    BOOST_TEST(has(time.out, "ATTRIBUTE \"units\"") == known, time.out);
    BOOST_TEST(has(time.out, "ATTRIBUTE \"axis\"") == known);
    BOOST_TEST(has(time.out, "seconds since 2000-01-01") == known);
    BOOST_TEST(has(rate.out, "\"s-1\"") == known, rate.out);
    if (installed("cdo")) {
      auto const told = shell("cdo sinfo " + path);
      BOOST_TEST(!has(told.out + told.err, "TIMEUNIT"), told.err);
      BOOST_TEST(has(told.out, "2000-01-01 00:00:02") == known, told.out);
    }
    if (shell("python3 -c 'import xarray, netCDF4'").status == 0) {
      auto const told = shell("python3 -W error -c 'import xarray; print(xarray.open_dataset(\"" + path +
                              "\").time.dtype)'");
      BOOST_TEST(told.status == 0, told.err);
      BOOST_TEST(has(told.out, known ? "datetime64" : "float64"), told.out);
    }
  }
}

// Of a flow in which all coefficients have come to life; some of their numbers are shorter than others.
BOOST_AUTO_TEST_CASE(a_dry_run_tells_how_large_they_will_be_and_whether_there_is_room) {
  Folder const folder;
  Sphere large = scene();
  large.n = "32", large.until = "20", large.every = "", large.step = "0.05";
  large.more = "formats = [\"csv\", \"netcdf\"]\nsnapshots = [\"u\"]\nsnapshot_at = [18, 19, 20]\n";
  run_in(folder, large);
  double size = 0;
  for (auto const& entry : std::filesystem::directory_iterator(folder / "out/snapshots"))
    size += static_cast<double>(entry.file_size());
  auto const plan = actio({"run", folder / "sphere.toml", "--dry-run"});
  std::string const says = "snapshots/ (3 snapshots, about ";
  auto const at = plan.out.find(says);
  BOOST_REQUIRE_MESSAGE(at != std::string::npos, plan.out);
  double const told = std::stod(plan.out.substr(at + says.size()));
  BOOST_TEST_MESSAGE("told " << told << ", found " << size);
  BOOST_TEST(has(plan.out.substr(at, 50), "kB"), plan.out);
  BOOST_TEST(std::abs(told * 1000 / size - 1) < 0.1);
  BOOST_TEST(!has(plan.out, "the disk has room for"), plan.out);
  // Nearly a million times four megabytes.
  large.n = "128", large.until = "40000",
  large.more = "formats = [\"csv\", \"netcdf\"]\nsnapshots = [\"u\", \"v\"]\nsnapshot_every = 0.05\n";
  auto const full = actio({"run", folder.write("large.toml", large.text()), "--dry-run"});
  BOOST_TEST(full.status == 0, full.err);
  BOOST_TEST(has(full.out, "or fewer snapshots (output.snapshot_every), take"), full.out);
}

BOOST_AUTO_TEST_CASE(a_run_that_was_killed_leaves_the_same) {
  Sphere long_run = scene();
  long_run.n = "24", long_run.until = "40";
  Folder const whole, cut;
  run_in(whole, long_run);
  std::string const file = cut.write("sphere.toml", long_run.text()), out = cut / "out";
  // Killed when it has written some.
  shell("ACTIO_CHECKPOINT_SECONDS=0.05 $ACTIO run " + file + " --out " + out + " & run=$!; while [ ! -e " +
        out + "/snapshots/000005.csv ] && kill -0 $run; do sleep 0.01; done; kill -9 $run; wait $run");
  auto const resumed = shell("$ACTIO resume " + out);
  BOOST_REQUIRE_MESSAGE(resumed.status == 0, resumed.err);
  auto const same = shell("diff -r -x summary.json -x checkpoint -x .actio " + whole / "out" + " " + out);
  BOOST_TEST(same.status == 0, same.out);
  // Further, from there: the snapshots that are there are the first of the longer run.
  BOOST_TEST(shell("$ACTIO resume " + out + " --until 42").status == 0);
  BOOST_TEST(numbers_of(cut, out + "/snapshots/fields.nc", "/time").size() == 43u);
}

BOOST_AUTO_TEST_CASE(a_map_is_drawn) {
  Folder const folder;
  Sphere drawn = scene();
  drawn.more += "plots = true\n";
  run_in(folder, drawn);
  std::string const map = contents(folder / "out/plots/vorticity.svg");
  std::size_t images = 0;
  for (std::size_t at = 0; (at = map.find("data:image/png;base64,iVBORw0KGgo", at)) != std::string::npos;
       ++at)
    ++images;
  BOOST_TEST(images == 4u);  // three times, and the scale
  for (char const* time : {">t = 0<", ">t = 1<", ">t = 2<"}) BOOST_TEST(has(map, time), time);
  // The page of the run plays them.
  std::string const page = folder / "out/plots/index.html";
  BOOST_TEST(has(contents(page), "\"maps\":{\"times\":[0,1,2]"));
  if (!command::there_is_node()) return;
  auto const told = command::page_in_node(page);
  BOOST_TEST(told.status == 0, told.err);
  BOOST_TEST(has(told.out, "\"views\":\"MapView\""), told.out);
}

BOOST_AUTO_TEST_SUITE_END()
