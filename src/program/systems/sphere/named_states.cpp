#include <Eigen/Core>

#include "program/systems/sphere/named_states.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

#include "program/systems/sphere/states.hpp"

namespace actio::scene {
namespace {

/// A degree below N: another message than that of a number out of its range.
Pattern<int> degree_below(int n) {
  return {"", [n](SceneTable const& table, std::string const& name) {
            int const l = Patterns::whole("", 1).read(table, name);
            if (l >= n)
              table.fail(name,
                         fmt::format("{}: the degree {} is outside of what matrices of this size hold: with "
                                     "N = {} degrees go from 1 to {}",
                                     name, l, n, n - 1));
            return l;
          }};
}

/// How strong a random flow is.
struct StrengthKeys : KeyTable {
  Key<double> energy =
      key("energy", number.called("a number, 0 or more").in("1/time^2"),
          LeftOut{"or " + name() + ".enstrophy; with neither, 1"}, "The energy of the flow.", "1");
  Key<double> enstrophy =
      key("enstrophy", number.called("a number, 0 or more").in("1/time^2"),
          LeftOut{"or " + name() + ".energy"}, "Its enstrophy, in the place of the energy.", "10");

  /// Random coefficients, each degree having on average so much of the energy; scaled to the energy, or the
  /// enstrophy, of the scene.
  sphere::SphereHarmonics random(StateRequest const& in, int last,
                                 std::function<double(int l)> const& share) const {
    auto f = in.hamiltonian.vorticity_of(random_flow(
        in.n, last, in.seed, [&](int l) { return share(l) * (l * (l + 1.0) / in.hamiltonian.divisor(l)); }));
    bool const by_enstrophy = enstrophy.given(in.file);
    if (by_enstrophy && energy.given(in.file))
      enstrophy.fail(in.file,
                     "energy and enstrophy exclude each other; one of them says how strong the flow is");
    auto const& said = by_enstrophy ? enstrophy : energy;
    double const wanted = by_enstrophy ? said.read(in.file) : said.read_or(in.file, 1);
    if (!(wanted >= 0)) said.fail(in.file, fmt::format("a number >= 0 is expected, found {}", wanted));
    double size = 0;
    for (int l = 1; l < f.degrees(); ++l)
      size += 0.5 * f.power(l) / (by_enstrophy ? 1 : in.hamiltonian.divisor(l));
    if (!(size > 0)) said.fail(in.file, "the flow has none that could be scaled");
    f.coefficient *= std::sqrt(wanted) / std::sqrt(size);
    return f;
  }
};

struct RossbyHaurwitzKeys : KeyTable {
  Key<int> degree =
      key("degree", whole("a whole number, 1 to N - 1", 1), LeftOut{"5"}, "The degree l of the wave.", "5");
  Key<int> order = key("order", whole("a whole number, 0 to the degree", 0), LeftOut{"4, or the degree"},
                       "Its order m.", "4");
  Key<double> amplitude =
      key("amplitude", number.in("1/time"), 1, "The coefficient of Y_lm, as in initial.harmonics.", "1");
  Key<double> zonal_rate =
      key("zonal_rate", number.in("1/time"), 0,
          "The angular velocity a of the rotation that the fluid has beside that of the sphere.", "0.5");
} const rossby_haurwitz{
    {"initial.rossby_haurwitz", other_start,
     "A wave of one degree on a zonal rotation, for which the exact motion is known: relative to the sphere "
     "it turns about the pole with the angular velocity a - (d_1 a + 2 rotation)/d_l, a = zonal_rate; d_l is "
     "l (l + 1), in a layer l (l + 1) + gamma, and as for the quantity spectrum in averaged flow.",
     "{ degree = 5, order = 4 }"}};

sphere::SphereHarmonics read_rossby_haurwitz(StateRequest const& in) {
  auto const& keys = rossby_haurwitz;
  int const l = keys.degree.read_or(in.file, std::min(5, in.n - 1), degree_below(in.n)),
            m = keys.order.read_or(in.file, std::min(4, l), Patterns::whole("", 0, l));
  sphere::SphereHarmonics f(in.n);
  f(1, 0) = rotation_coefficient(keys.zonal_rate.read(in.file));
  f = in.hamiltonian.vorticity_of(f);
  f(l, m) += keys.amplitude.read(in.file);
  return f;
}

struct Wave4Keys : KeyTable {
  LeftOut const usual{"0.1076 of the rotation, as in case 6; without one 1"};
  Key<double> amplitude = key("amplitude", number.in("1/time"), usual, "K.", "1");
  Key<double> zonal_rate = key("zonal_rate", number.in("1/time"), usual, "a.", "1");
} const wave_4{{"initial.rossby_haurwitz_4", other_start,
                "The wave with four crests of Williamson's case 6, of the degree 5 and the order 4: the "
                "Laplacian of psi is 2 a sin(phi) - 30 K sin(phi) cos(phi)^4 cos(4 lambda).",
                "{ amplitude = 1 }"}};

sphere::SphereHarmonics read_wave_4(StateRequest const& in) {
  if (in.n < 6)
    throw SceneError(in.file.section(wave_4.name()).place(),
                     fmt::format("rossby_haurwitz_4: it is a wave of degree 5; with "
                                 "N = {} degrees go from 1 to {}",
                                 in.n, in.n - 1));
  // 7.848e-6 beside the 7.292e-5 of the Earth, both per second.
  double const usual = in.rotation != 0 ? 7.848 / 72.92 * std::abs(in.rotation) : 1;
  sphere::SphereHarmonics f(in.n);
  f(1, 0) = rotation_coefficient(wave_4.zonal_rate.read_or(in.file, usual));
  f(5, 4) = wave_4_coefficient(wave_4.amplitude.read_or(in.file, usual));
  return in.hamiltonian.vorticity_of(f);
}

struct RandomKeys : KeyTable {
  Key<int> lmin = key("lmin", whole("a whole number, 1 to lmax", 1), 1, "The first degree.", "2");
  Key<int> lmax =
      key("lmax", whole("a whole number, 1 to N - 1", 1), LeftOut{"10, or N - 1"}, "The last degree.", "10");
  Key<double> slope = key("slope", number.called("an exponent, -100 to 100"), 0,
                          "The energy in the degree l is on average proportional to this power of l.", "-3");
} const random_keys{{"initial.random", other_start,
                     "Random coefficients, normally distributed, from scene.seed.", "{ lmax = 10 }"}};
StrengthKeys const random_strength{{"initial.random"}};

sphere::SphereHarmonics read_random(StateRequest const& in) {
  int const last = random_keys.lmax.read_or(in.file, std::min(10, in.n - 1), degree_below(in.n)),
            first = random_keys.lmin.read(in.file, Patterns::whole("", 1, last));
  double const slope = random_keys.slope.read(in.file);
  if (!(std::abs(slope) <= 100))
    random_keys.slope.fail(in.file, fmt::format("an exponent from -100 to 100 is expected, found {}", slope));
  return random_strength.random(
      in, last, [&](int l) { return l < first ? 0 : std::pow(static_cast<double>(l) / first, slope); });
}

struct RingKeys : KeyTable {
  Key<int> degree = key("degree", whole("a whole number, 1 to N - 1", 1), LeftOut{"N/4"},
                        "The degree in the middle.", "12");
  Key<double> width = key("width", positive.called("a real > 0, in degrees l"), 1,
                          "How far the energy reaches on either side.", "2");
} const ring_keys{
    {"initial.ring", other_start,
     "Random coefficients around one degree, from which turbulence grows: the energy in the degree "
     "l is on average proportional to exp(-(l - degree)^2/(2 width^2)).",
     "{ degree = 12 }"}};
StrengthKeys const ring_strength{{"initial.ring"}};

sphere::SphereHarmonics read_ring(StateRequest const& in) {
  int const centre =
      ring_keys.degree.read_or(in.file, std::min(std::max(1, in.n / 4), in.n - 1), degree_below(in.n));
  double const width = ring_keys.width.read(in.file);
  return ring_strength.random(in, in.n - 1, [&](int l) {
    double const x = (l - centre) / width;
    return std::exp(-0.5 * x * x);
  });
}

constexpr double pi = std::numbers::pi;

struct JetKeys : KeyTable {
  Pattern<double> const latitude = number.called("a number from -pi/2 to pi/2").in("radians");
  Key<double> speed =
      key("speed", number.in("1/time"), 1, "The largest velocity, in radii of the sphere.", "1");
  Key<double> south =
      key("south", latitude, LeftOut{"pi/7"}, "The latitude where the jet begins.", "0.4487989505128276");
  Key<double> north =
      key("north", latitude, LeftOut{"5 pi/14"}, "The latitude where it ends.", "1.121997376282069");
  Key<double> perturbation =
      key("perturbation", number.in("1/time"), 0,
          "The height p of a patch on the jet, which the Laplacian of psi has besides: p cos(phi) exp(-(3 "
          "lambda)^2) exp(-(15 (phi - pi/4))^2).",
          "0.1");
} const jet_keys{
    {"initial.zonal_jet", other_start,
     "A jet towards the east along a circle of latitude, with the profile of Galewsky, Scott and "
     "Polvani (2004); theirs has the speed 0.1722 in units of the rotation.",
     "{ speed = 1, perturbation = 0.1 }"}};

sphere::SphereHarmonics read_zonal_jet(StateRequest const& in) {
  auto const& [speed, south, north, patch] =
      std::tie(jet_keys.speed, jet_keys.south, jet_keys.north, jet_keys.perturbation);
  ZonalJet const jet{speed.read(in.file), south.read_or(in.file, pi / 7),
                     north.read_or(in.file, pi / 2 - pi / 7), patch.read(in.file)};
  for (auto const& [key, latitude] : {std::tie(south, jet.south), std::tie(north, jet.north)})
    if (!(std::abs(latitude) <= pi / 2))
      key.fail(in.file,
               fmt::format("a latitude in radians is expected, from -pi/2 to pi/2, found {}", latitude));
  if (!(jet.north - jet.south >= 0.01))
    north.fail(in.file, fmt::format("the jet lies between south = {} and north = {}, radians; north is "
                                    "to be greater by at least 0.01",
                                    jet.south, jet.north));
  return in.hamiltonian.vorticity_of(zonal_jet(in.n, jet));
}

/// Rows that begin with a longitude and a latitude.
Eigen::MatrixXd read_places(StateRequest const& in, Key<Eigen::MatrixXd> const& key,
                            Eigen::MatrixXd const& otherwise) {
  auto const rows = key.read_or(in.file, otherwise);
  if (rows.rows() == 0) key.fail(in.file, "at least one row is expected, found none");
  for (int i = 0; i < rows.rows(); ++i)
    if (!(std::abs(rows(i, 1)) <= pi / 2 + 1e-12))
      key.fail_at(in.file, static_cast<std::size_t>(i),
                  fmt::format("the second of a row is a latitude in radians, from -pi/2 to pi/2; found {}",
                              rows(i, 1)));
  return rows;
}

struct BlobKeys : KeyTable {
  Key<Eigen::MatrixXd> places = key(
      "rows",
      rows("a list of rows of four numbers: longitude, latitude, width, strength", 4)
          .in("radians, and 1/time"),
      LeftOut{"three blobs"},
      "For each the vorticity strength exp(-(1 - cos(gamma))/width^2) at the angle gamma from its centre.",
      "[[0, 0.4, 0.3, 1], [0.9, 0.4, 0.3, 1]]");
} const blob_keys{{"initial.blobs", other_start, "Rounded patches of vorticity; their mean is taken out.",
                   "{ rows = [[0, 0.4, 0.3, 1], [0.9, 0.4, 0.3, 1]] }"}};

sphere::SphereHarmonics read_blobs(StateRequest const& in) {
  auto const rows =
      read_places(in, blob_keys.places,
                  Eigen::MatrixXd{{0.0, 0.4, 0.3, 1.0}, {0.9, 0.4, 0.3, 1.0}, {3.0, -0.3, 0.4, -1.0}});
  std::vector<Blob> all;
  for (int i = 0; i < rows.rows(); ++i) {
    if (!(rows(i, 2) >= 1e-3 && rows(i, 2) <= 10))
      blob_keys.places.fail_at(
          in.file, static_cast<std::size_t>(i),
          fmt::format("the third of a row is the width in radians, from 0.001 to 10; found {}", rows(i, 2)));
    all.push_back({rows(i, 0), rows(i, 1), rows(i, 2), rows(i, 3)});
  }
  return blobs(in.n, all);
}

struct VortexKeys : KeyTable {
  Key<Eigen::MatrixXd> places = key(
      "rows",
      rows("a list of rows of three numbers: longitude, latitude, circulation", 3).in("radians, and 1/time"),
      LeftOut{"three vortices"}, "For each where it is, and the integral of its vorticity.",
      "[[0, 0.4, 1], [1, -0.2, 1]]");
} const vortex_keys{{"initial.point_vortices", other_start,
                     "Vortices as narrow as matrices of the size N have them, about 1/sqrt(N) "
                     "radians; their mean is taken out.",
                     "{ rows = [[0, 0.4, 1], [1, -0.2, 1]] }"}};

sphere::SkewHermitian<> read_point_vortices(StateRequest const& in) {
  std::vector<PointVortex> all;
  auto const rows = read_places(in, vortex_keys.places,
                                Eigen::MatrixXd{{0.0, 0.4, 1.0}, {1.0, -0.2, 1.0}, {3.0, 0.3, -1.0}});
  for (int i = 0; i < rows.rows(); ++i) all.push_back({rows(i, 0), rows(i, 1), rows(i, 2)});
  return point_vortices(in.n, all);
}

/// A named state.
struct State {
  char const* name;
  sphere::SphereHarmonics (*read)(StateRequest const& in);  ///< null: as a matrix
};
constexpr State states[] = {{"rossby_haurwitz", read_rossby_haurwitz},
                            {"rossby_haurwitz_4", read_wave_4},
                            {"random", read_random},
                            {"ring", read_ring},
                            {"zonal_jet", read_zonal_jet},
                            {"blobs", read_blobs},
                            {"point_vortices", nullptr}};

}  // namespace

std::vector<std::string> names_of_states() { return names_of(states); }

std::vector<Parameter> parameters_of_states() {
  return records_of({rossby_haurwitz, wave_4, random_keys, random_strength, ring_keys, ring_strength,
                     jet_keys, blob_keys, vortex_keys});
}

NamedFlow read_named_state(std::string const& name, StateRequest const& in) {
  auto const* const known = std::ranges::find(states, name, &State::name);
  NamedFlow flow;
  if (known->read) {
    flow.relative = known->read(in), flow.matrix = sphere::matrix_of(flow.relative);
  } else {
    flow.matrix = read_point_vortices(in), flow.relative = sphere::harmonics_of(flow.matrix);
  }
  return flow;
}

}  // namespace actio::scene
