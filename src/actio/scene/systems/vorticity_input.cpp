#include "actio/scene/systems/vorticity_input.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>
#include <numbers>

#include "actio/numbers/nearest_name.hpp"
#include "actio/scene/systems/vorticity_states.hpp"
#include "actio/vorticity/sphere_invariants.hpp"

namespace actio::scene {
namespace {

/// What a state is made of, and the table of [initial] that holds its parameters.
struct Reader {
  SceneTable table;
  int n;
  double rotation;
  long seed;

  double number(char const* key, double otherwise) {
    if (!table.has(key)) table.set(key, otherwise);
    return table.number(key);
  }
  double positive(char const* key, double otherwise) {
    number(key, otherwise);
    return table.positive(key);
  }
  int whole(char const* key, int otherwise, int least, int most) {
    if (!table.has(key)) table.set(key, static_cast<long>(otherwise));
    return static_cast<int>(table.integer(key, least, most));
  }
  /// A degree below N: another message than that of a number out of its range.
  int degree(char const* key, int otherwise, int least = 1) {
    if (!table.has(key)) table.set(key, static_cast<long>(otherwise));
    long const l = table.integer(key, least, std::numeric_limits<int>::max());
    if (l >= n)
      table.fail(key,
                 fmt::format("{}: the degree {} is outside of what matrices of this size hold: with N = {} "
                             "degrees go from 1 to {}",
                             key, l, n, n - 1));
    return static_cast<int>(l);
  }
  /// Scaled to the energy, or the enstrophy, of the scene.
  SphereHarmonics scaled(SphereHarmonics f) {
    if (table.has("energy") && table.has("enstrophy"))
      table.fail("enstrophy",
                 "enstrophy: energy and enstrophy exclude each other; one of them says how strong the "
                 "flow is");
    bool const by_enstrophy = table.has("enstrophy");
    double const wanted = by_enstrophy ? table.number("enstrophy") : number("energy", 1);
    char const* const key = by_enstrophy ? "enstrophy" : "energy";
    if (!(wanted >= 0)) table.fail(key, fmt::format("{}: a number >= 0 is expected, found {}", key, wanted));
    double size = 0;
    for (int l = 1; l < f.degrees(); ++l) size += 0.5 * f.power(l) / (by_enstrophy ? 1 : l * (l + 1.0));
    if (!(size > 0)) table.fail(key, fmt::format("{}: the flow has none that could be scaled", key));
    f.coefficient *= std::sqrt(wanted) / std::sqrt(size);
    return f;
  }
};

SphereHarmonics read_rossby_haurwitz(Reader& in) {
  int const l = in.degree("degree", std::min(5, in.n - 1)), m = in.whole("order", std::min(4, l), 0, l);
  SphereHarmonics f(in.n);
  f(1, 0) = rotation_coefficient(in.number("zonal_rate", 0));
  f(l, m) += in.number("amplitude", 1);
  return f;
}

SphereHarmonics read_wave_4(Reader& in) {
  if (in.n < 6)
    throw SceneError(in.table.place(),
                     fmt::format("rossby_haurwitz_4: it is a wave of degree 5; with N = {} degrees "
                                 "go from 1 to {}",
                                 in.n, in.n - 1));
  // 7.848e-6 beside the 7.292e-5 of the Earth, both per second.
  double const usual = in.rotation != 0 ? 7.848 / 72.92 * std::abs(in.rotation) : 1;
  SphereHarmonics f(in.n);
  f(1, 0) = rotation_coefficient(in.number("zonal_rate", usual));
  f(5, 4) = wave_4_coefficient(in.number("amplitude", usual));
  return f;
}

SphereHarmonics read_random(Reader& in) {
  int const last = in.degree("lmax", std::min(10, in.n - 1)), first = in.whole("lmin", 1, 1, last);
  double const slope = in.number("slope", 0);
  if (!(std::abs(slope) <= 100))
    in.table.fail("slope", fmt::format("slope: an exponent from -100 to 100 is expected, found {}", slope));
  return in.scaled(random_flow(in.n, last, in.seed, [&](int l) {
    return l < first ? 0 : std::pow(static_cast<double>(l) / first, slope);
  }));
}

SphereHarmonics read_ring(Reader& in) {
  int const centre = in.degree("degree", std::min(std::max(1, in.n / 4), in.n - 1));
  double const width = in.positive("width", 1);
  return in.scaled(random_flow(in.n, in.n - 1, in.seed, [&](int l) {
    double const x = (l - centre) / width;
    return std::exp(-0.5 * x * x);
  }));
}

SphereHarmonics read_zonal_jet(Reader& in) {
  constexpr double pi = std::numbers::pi;
  ZonalJet jet{};
  jet.speed = in.number("speed", 1);
  jet.south = in.number("south", pi / 7), jet.north = in.number("north", pi / 2 - pi / 7);
  jet.perturbation = in.number("perturbation", 0);
  for (char const* key : {"south", "north"})
    if (!(std::abs(in.table.number(key)) <= pi / 2))
      in.table.fail(key, fmt::format("{}: a latitude in radians is expected, from -pi/2 to pi/2, found {}",
                                     key, in.table.number(key)));
  if (!(jet.north - jet.south >= 0.01))
    in.table.fail(
        "north", fmt::format("north: the jet lies between south = {} and north = {}, radians; north is to be "
                             "greater by at least 0.01",
                             jet.south, jet.north));
  return zonal_jet(in.n, jet);
}

/// Rows that begin with a longitude and a latitude.
std::vector<std::vector<double>> read_places(Reader& in, char const* key, long size) {
  auto const rows = in.table.rows(key, size);
  if (rows.empty()) in.table.fail(key, fmt::format("{}: at least one row is expected, found none", key));
  for (std::size_t i = 0; i < rows.size(); ++i)
    if (!(std::abs(rows[i][1]) <= std::numbers::pi / 2 + 1e-12))
      throw SceneError(
          in.table.place(key, i),
          fmt::format("{}: the second of a row is a latitude in radians, from -pi/2 to pi/2; found {}", key,
                      rows[i][1]));
  return rows;
}

SphereHarmonics read_blobs(Reader& in) {
  if (!in.table.has("rows"))
    in.table.set("rows", Eigen::MatrixXd{{0.0, 0.4, 0.3, 1.0}, {0.9, 0.4, 0.3, 1.0}, {3.0, -0.3, 0.4, -1.0}});
  auto const rows = read_places(in, "rows", 4);
  std::vector<Blob> all;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    auto const& row = rows[i];
    if (!(row[2] >= 1e-3 && row[2] <= 10))
      throw SceneError(
          in.table.place("rows", i),
          fmt::format("rows: the third of a row is the width in radians, from 0.001 to 10; found {}",
                      row[2]));
    all.push_back({row[0], row[1], row[2], row[3]});
  }
  return blobs(in.n, all);
}

SkewHermitian<> read_point_vortices(Reader& in) {
  if (!in.table.has("rows"))
    in.table.set("rows", Eigen::MatrixXd{{0.0, 0.4, 1.0}, {1.0, -0.2, 1.0}, {3.0, 0.3, -1.0}});
  std::vector<PointVortex> all;
  for (auto const& row : read_places(in, "rows", 3)) all.push_back({row[0], row[1], row[2]});
  return point_vortices(in.n, all);
}

/// A named state.
struct State {
  char const* name;
  SphereHarmonics (*read)(Reader& in);  ///< null: as a matrix
};
constexpr State states[] = {{"rossby_haurwitz", read_rossby_haurwitz},
                            {"rossby_haurwitz_4", read_wave_4},
                            {"random", read_random},
                            {"ring", read_ring},
                            {"zonal_jet", read_zonal_jet},
                            {"blobs", read_blobs},
                            {"point_vortices", nullptr}};

std::vector<std::string> names_of_states() {
  std::vector<std::string> out;
  for (auto const& state : states) out.emplace_back(state.name);
  return out;
}

/// The state that the scene names, by `state` or by the table of its parameters; empty where it names none.
std::string state_of(SceneTable& initial) {
  auto const names = names_of_states();
  std::vector<std::string> tables;
  for (auto const& key : initial.keys())
    if (std::find(names.begin(), names.end(), key) != names.end()) tables.push_back(key);
  for (auto const& name : tables)
    if (!initial.is_table(name))
      initial.fail(name, fmt::format("{0}: a table is expected, [initial.{0}], which may be empty", name));
  if (tables.size() > 1)
    initial.fail(tables[1], fmt::format("[initial] has '{}' and '{}'; one of them says how the flow begins",
                                        tables[0], tables[1]));
  if (!initial.has("state")) return tables.empty() ? "" : tables[0];
  std::string const name = initial.choice("state", "state", names);
  if (!tables.empty() && tables[0] != name)
    initial.fail(tables[0], fmt::format("[initial.{}] holds parameters of another state than state = \"{}\"",
                                        tables[0], name));
  return name;
}

void read_rows(SceneTable const& initial, SphereHarmonics& f) {
  auto const rows = initial.rows("harmonics", 4);
  Eigen::MatrixXi lines = Eigen::MatrixXi::Zero(f.degrees(), f.degrees());
  for (std::size_t i = 0; i < rows.size(); ++i) {
    auto const& row = rows[i];
    std::string const wrong =
        put_coefficient(f, lines, -static_cast<int>(i) - 1, row[0], row[1], row[2], row[3]);
    if (!wrong.empty()) throw SceneError(initial.place("harmonics", i), "harmonics: " + wrong);
  }
}

/// A path in a scene is one beside the scene.
std::string beside(std::string const& scene, std::string const& path) {
  namespace fs = std::filesystem;
  std::error_code error;
  fs::path const full = fs::path(path).is_absolute() ? fs::path(path) : fs::path(scene).parent_path() / path;
  fs::path const absolute = fs::absolute(full, error);
  return (error ? full : absolute.lexically_normal()).string();
}

}  // namespace

int read_matrix_size(SceneTable const& system) { return static_cast<int>(system.integer("N", 2, 1L << 20)); }

VorticityStart read_vorticity_start(SceneFile const& file, std::vector<std::string>& remarks) {
  SceneTable system = file.section("system"), initial = file.section("initial");
  VorticityStart start;
  start.n = read_matrix_size(system);
  if (!system.has("rotation")) system.set("rotation", 0.0);
  start.rotation = system.number("rotation");

  std::string const state = state_of(initial);
  std::vector<std::string> given;
  for (char const* key : {"harmonics", "file"})
    if (initial.has(key)) given.emplace_back(key);
  if (!state.empty()) given.push_back(initial.has("state") ? "state" : state);
  if (given.empty())
    throw SceneError(
        initial.place(),
        "[initial] needs 'harmonics', rows l, m, re, im; or 'file', a table of such rows; or 'state', one "
        "of " +
            listed(names_of_states()));
  if (given.size() > 1)
    initial.fail(given[1], fmt::format("[initial] has '{}' and '{}'; one of them says how the flow begins",
                                       given[0], given[1]));
  start.key = given[0];

  start.relative = SphereHarmonics(start.n);
  if (given[0] == "harmonics") {
    read_rows(initial, start.relative);
  } else if (given[0] == "file") {
    std::string const path = beside(file.name(), initial.text("file"));
    try {
      start.relative = read_harmonics_file(path, start.n);
    } catch (SceneError const& error) {
      initial.fail("file", std::string("file: ") + error.what());
    }
    if (path != initial.text("file")) initial.set("file", path);
    remarks.push_back(
        "file: the copy of the scene names it by its whole path; who repeats or resumes the run needs it "
        "there, as it is now");
  } else {
    initial.set("state", state);
    Reader in{initial.inside(state), start.n, start.rotation,
              file.section("scene").integer("seed", 0, std::numeric_limits<long>::max())};
    auto const* const known =
        std::find_if(std::begin(states), std::end(states), [&](State const& s) { return s.name == state; });
    if (!known->read) {
      start.matrix = read_point_vortices(in);
      start.relative = harmonics_of(start.matrix);
      return start;
    }
    start.relative = known->read(in);
  }
  start.matrix = matrix_of(start.relative);
  return start;
}

std::vector<Parameter> vorticity_parameters() {
  std::string const others = "or initial.harmonics or initial.file";
  std::vector<Parameter> all{
      {"system.N", "a whole number, 2 or more", "needed",
       "The size of the matrices: functions have the degrees 0 to N - 1. Time grows with N^3 and memory with "
       "N^2; "
       "interactions of waves of the degree l are those of the sphere but for a part of about l^4/(6 N^2).",
       "", "64"},
      {"system.rotation", "a number", "0",
       "The angular velocity of the sphere about the pole. The flow is told relative to the sphere, d "
       "zeta/dt + u . "
       "grad(zeta + 2 rotation cos(theta)) = 0.",
       "1/time", "1.0"},
      {"initial.harmonics", "a list of rows of four numbers: l, m, re, im",
       "or initial.file or initial.state",
       "The coefficients of the vorticity relative to the sphere, in orthonormal complex spherical harmonics "
       "with the "
       "Condon-Shortley phase. 0 <= m <= l, 1 <= l < N; those of -m follow, since the field is real. What is "
       "left out "
       "is zero.",
       "1/time", "[[5, 3, 0.2, 0.1], [1, 0, 0.5, 0.0]]"},
      {"initial.file", "a text, the path of a file beside the scene", "or initial.harmonics or initial.state",
       "The same as a file with the heading l,m,re,im, as snapshots write it: every order of every degree up "
       "to the "
       "last one.",
       "", "\"vorticity.csv\""},
      {"initial.state", "a text", others,
       "A flow by its name; its parameters are in a table of that name, for instance [initial.random] with "
       "lmax = 10, "
       "and where there is such a table it names the state.",
       "", "\"random\"", names_of_states()},
  };
  auto const table = [&](std::string const& name, std::string const& meaning, std::string const& example) {
    all.push_back({"initial." + name, "a table", others, meaning, "", example});
  };
  auto const key = [&](std::string const& name, std::string const& expects, std::string const& fallback,
                       std::string const& meaning, std::string const& unit, std::string const& example) {
    all.push_back({"initial." + name, expects, fallback, meaning, unit, example});
  };
  table("rossby_haurwitz",
        "A wave of one degree on a zonal rotation, for which the exact motion is known: it turns about the "
        "pole "
        "with the angular velocity a - 2 (a + rotation)/(l (l + 1)) relative to the sphere, a = zonal_rate.",
        "{ degree = 5, order = 4 }");
  key("rossby_haurwitz.degree", "a whole number, 1 to N - 1", "5", "The degree l of the wave.", "", "5");
  key("rossby_haurwitz.order", "a whole number, 0 to the degree", "4, or the degree", "Its order m.", "",
      "4");
  key("rossby_haurwitz.amplitude", "a number", "1", "The coefficient of Y_lm, as in initial.harmonics.",
      "1/time", "1");
  key("rossby_haurwitz.zonal_rate", "a number", "0",
      "The angular velocity a of the rotation that the fluid has beside that of the sphere.", "1/time",
      "0.5");
  table("rossby_haurwitz_4",
        "The wave with four crests of Williamson's case 6, of the degree 5 and the order 4: the vorticity is "
        "2 a sin(phi) - 30 K sin(phi) cos(phi)^4 cos(4 lambda).",
        "{ amplitude = 1 }");
  key("rossby_haurwitz_4.amplitude", "a number", "0.1076 of the rotation, as in case 6; without one 1", "K.",
      "1/time", "1");
  key("rossby_haurwitz_4.zonal_rate", "a number", "0.1076 of the rotation, as in case 6; without one 1", "a.",
      "1/time", "1");
  table("random", "Random coefficients, normally distributed, from scene.seed.", "{ lmax = 10 }");
  key("random.lmin", "a whole number, 1 to lmax", "1", "The first degree.", "", "2");
  key("random.lmax", "a whole number, 1 to N - 1", "10, or N - 1", "The last degree.", "", "10");
  key("random.slope", "an exponent, -100 to 100", "0",
      "The energy in the degree l is on average proportional to this power of l.", "", "-3");
  key("random.energy", "a number, 0 or more", "or initial.random.enstrophy; with neither, 1",
      "The energy of the flow.", "1/time^2", "1");
  key("random.enstrophy", "a number, 0 or more", "or initial.random.energy",
      "Its enstrophy, in the place of the energy.", "1/time^2", "10");
  table("ring",
        "Random coefficients around one degree, from which turbulence grows: the energy in the degree l is "
        "on average "
        "proportional to exp(-(l - degree)^2/(2 width^2)).",
        "{ degree = 12 }");
  key("ring.degree", "a whole number, 1 to N - 1", "N/4", "The degree in the middle.", "", "12");
  key("ring.width", "a real > 0, in degrees l", "1", "How far the energy reaches on either side.", "", "2");
  key("ring.energy", "a number, 0 or more", "or initial.ring.enstrophy; with neither, 1",
      "The energy of the flow.", "1/time^2", "1");
  key("ring.enstrophy", "a number, 0 or more", "or initial.ring.energy",
      "Its enstrophy, in the place of the energy.", "1/time^2", "10");
  table("zonal_jet",
        "A jet towards the east along a circle of latitude, with the profile of Galewsky, Scott and Polvani "
        "(2004); "
        "theirs has the speed 0.1722 in units of the rotation.",
        "{ speed = 1, perturbation = 0.1 }");
  key("zonal_jet.speed", "a number", "1", "The largest velocity, in radii of the sphere.", "1/time", "1");
  key("zonal_jet.south", "a number from -pi/2 to pi/2", "pi/7", "The latitude where the jet begins.",
      "radians", "0.4487989505128276");
  key("zonal_jet.north", "a number from -pi/2 to pi/2", "5 pi/14", "The latitude where it ends.", "radians",
      "1.121997376282069");
  key("zonal_jet.perturbation", "a number", "0",
      "The height p of a patch of vorticity on the jet, p cos(phi) exp(-(3 lambda)^2) exp(-(15 (phi - "
      "pi/4))^2).",
      "1/time", "0.1");
  table("blobs", "Rounded patches of vorticity; their mean is taken out.",
        "{ rows = [[0, 0.4, 0.3, 1], [0.9, 0.4, 0.3, 1]] }");
  key("blobs.rows", "a list of rows of four numbers: longitude, latitude, width, strength", "three blobs",
      "For each the vorticity strength exp(-(1 - cos(gamma))/width^2) at the angle gamma from its centre.",
      "radians, and 1/time", "[[0, 0.4, 0.3, 1], [0.9, 0.4, 0.3, 1]]");
  table("point_vortices",
        "Vortices as narrow as matrices of the size N have them, about 1/sqrt(N) radians; their mean is "
        "taken out.",
        "{ rows = [[0, 0.4, 1], [1, -0.2, 1]] }");
  key("point_vortices.rows", "a list of rows of three numbers: longitude, latitude, circulation",
      "three vortices", "For each where it is, and the integral of its vorticity.", "radians, and 1/time",
      "[[0, 0.4, 1], [1, -0.2, 1]]");
  return all;
}

}  // namespace actio::scene
