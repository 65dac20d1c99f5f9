#include <Eigen/Core>

#include "program/systems/sphere/named_states.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>

#include "program/systems/sphere/states.hpp"

namespace actio::scene {
namespace {

/// Reads numbers of the table, and writes defaults back.
struct Reader : StateRequest {
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
      table.fail(key, fmt::format("{}: the degree {} is outside of what matrices of this size hold: with "
                                  "N = {} degrees go from 1 to {}",
                                  key, l, n, n - 1));
    return static_cast<int>(l);
  }
  /// Random coefficients, each degree having on average so much of the energy; scaled to the energy, or the
  /// enstrophy, of the scene.
  sphere::SphereHarmonics random(int last, std::function<double(int l)> const& energy) {
    return scaled(hamiltonian.vorticity_of(random_flow(
        n, last, seed, [&](int l) { return energy(l) * (l * (l + 1.0) / hamiltonian.divisor(l)); })));
  }
  /// Scaled to the energy, or the enstrophy, of the scene.
  sphere::SphereHarmonics scaled(sphere::SphereHarmonics f) {
    if (table.has("energy") && table.has("enstrophy"))
      table.fail("enstrophy",
                 "enstrophy: energy and enstrophy exclude each other; one of "
                 "them says how strong the flow is");
    bool const by_enstrophy = table.has("enstrophy");
    double const wanted = by_enstrophy ? table.number("enstrophy") : number("energy", 1);
    char const* const key = by_enstrophy ? "enstrophy" : "energy";
    if (!(wanted >= 0)) table.fail(key, fmt::format("{}: a number >= 0 is expected, found {}", key, wanted));
    double size = 0;
    for (int l = 1; l < f.degrees(); ++l)
      size += 0.5 * f.power(l) / (by_enstrophy ? 1 : hamiltonian.divisor(l));
    if (!(size > 0)) table.fail(key, fmt::format("{}: the flow has none that could be scaled", key));
    f.coefficient *= std::sqrt(wanted) / std::sqrt(size);
    return f;
  }
};

sphere::SphereHarmonics read_rossby_haurwitz(Reader& in) {
  int const l = in.degree("degree", std::min(5, in.n - 1)), m = in.whole("order", std::min(4, l), 0, l);
  sphere::SphereHarmonics f(in.n);
  f(1, 0) = rotation_coefficient(in.number("zonal_rate", 0));
  f = in.hamiltonian.vorticity_of(f);
  f(l, m) += in.number("amplitude", 1);
  return f;
}

sphere::SphereHarmonics read_wave_4(Reader& in) {
  if (in.n < 6)
    throw SceneError(in.table.place(), fmt::format("rossby_haurwitz_4: it is a wave of degree 5; with "
                                                   "N = {} degrees go from 1 to {}",
                                                   in.n, in.n - 1));
  // 7.848e-6 beside the 7.292e-5 of the Earth, both per second.
  double const usual = in.rotation != 0 ? 7.848 / 72.92 * std::abs(in.rotation) : 1;
  sphere::SphereHarmonics f(in.n);
  f(1, 0) = rotation_coefficient(in.number("zonal_rate", usual));
  f(5, 4) = wave_4_coefficient(in.number("amplitude", usual));
  return in.hamiltonian.vorticity_of(f);
}

sphere::SphereHarmonics read_random(Reader& in) {
  int const last = in.degree("lmax", std::min(10, in.n - 1)), first = in.whole("lmin", 1, 1, last);
  double const slope = in.number("slope", 0);
  if (!(std::abs(slope) <= 100))
    in.table.fail("slope", fmt::format("slope: an exponent from -100 to 100 is expected, found {}", slope));
  return in.random(last,
                   [&](int l) { return l < first ? 0 : std::pow(static_cast<double>(l) / first, slope); });
}

sphere::SphereHarmonics read_ring(Reader& in) {
  int const centre = in.degree("degree", std::min(std::max(1, in.n / 4), in.n - 1));
  double const width = in.positive("width", 1);
  return in.random(in.n - 1, [&](int l) {
    double const x = (l - centre) / width;
    return std::exp(-0.5 * x * x);
  });
}

sphere::SphereHarmonics read_zonal_jet(Reader& in) {
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
    in.table.fail("north",
                  fmt::format("north: the jet lies between south = {} and north = {}, radians; north is "
                              "to be greater by at least 0.01",
                              jet.south, jet.north));
  return in.hamiltonian.vorticity_of(zonal_jet(in.n, jet));
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

sphere::SphereHarmonics read_blobs(Reader& in) {
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

sphere::SkewHermitian<> read_point_vortices(Reader& in) {
  if (!in.table.has("rows"))
    in.table.set("rows", Eigen::MatrixXd{{0.0, 0.4, 1.0}, {1.0, -0.2, 1.0}, {3.0, 0.3, -1.0}});
  std::vector<PointVortex> all;
  for (auto const& row : read_places(in, "rows", 3)) all.push_back({row[0], row[1], row[2]});
  return point_vortices(in.n, all);
}

/// A named state.
struct State {
  char const* name;
  sphere::SphereHarmonics (*read)(Reader& in);  ///< null: as a matrix
};
constexpr State states[] = {{"rossby_haurwitz", read_rossby_haurwitz},
                            {"rossby_haurwitz_4", read_wave_4},
                            {"random", read_random},
                            {"ring", read_ring},
                            {"zonal_jet", read_zonal_jet},
                            {"blobs", read_blobs},
                            {"point_vortices", nullptr}};

}  // namespace

std::vector<std::string> names_of_states() {
  std::vector<std::string> out;
  for (auto const& state : states) out.emplace_back(state.name);
  return out;
}

NamedFlow read_named_state(std::string const& name, StateRequest request) {
  Reader in{std::move(request)};
  auto const* const known =
      std::find_if(std::begin(states), std::end(states), [&](State const& s) { return s.name == name; });
  NamedFlow flow;
  if (known->read) {
    flow.relative = known->read(in), flow.matrix = sphere::matrix_of(flow.relative);
  } else {
    flow.matrix = read_point_vortices(in), flow.relative = sphere::harmonics_of(flow.matrix);
  }
  return flow;
}

}  // namespace actio::scene
