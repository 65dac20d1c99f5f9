#include "program/systems/torus/named_states.hpp"

#include <fmt/format.h>

#include <cmath>
#include <cstdint>
#include <numbers>

#include "actio/quantized_torus/torus_invariants.hpp"

namespace actio::scene {
namespace {

constexpr double pi = std::numbers::pi;

/// A wave number that matrices of the size N hold.
Pattern<int> wave_number(int n) {
  return {"", [n](SceneTable const& table, std::string const& name) {
            int const k = Patterns::whole("", 1).read(table, name), most = (n - 1) / 2;
            if (k > most)
              table.fail(name, fmt::format("{}: the wave number {} is outside of what matrices of this size "
                                           "hold: with N = {} they go up to {}",
                                           name, k, n, most));
            return k;
          }};
}

struct TaylorGreenKeys : KeyTable {
  Key<int> waves =
      key("wave_number", whole("a whole number, 1 to (N - 1)/2", 1), 1, "The wave number k.", "1");
  Key<double> amplitude = key("amplitude", number.in("1/time"), 1, "The amplitude a.", "1");
} const taylor_green{{"initial.taylor_green", other_torus_start,
                      "Vortices in a square, a cos(k x) cos(k y): they stand still.", "{ wave_number = 1 }"}};

torus::TorusHarmonics read_taylor_green(TorusStateRequest const& in) {
  int const k = taylor_green.waves.read(in.file, wave_number(in.n));
  double const a = taylor_green.amplitude.read(in.file);
  torus::TorusHarmonics f(in.n);
  f.set(k, k, a / 4), f.set(-k, k, a / 4);
  return f;
}

struct ShearKeys : KeyTable {
  Key<double> speed =
      key("speed", number.in("lengths/time"), 1, "U, half of the difference of the velocities.", "1");
  Key<double> width =
      key("width", number.called("a number from 0.01 to 1").in("lengths, of which a side has 2 pi"),
          LeftOut{"pi/15"}, "Of a layer: the velocity is U tanh(y/width) across it.", "0.2");
  Key<double> perturbation = key("perturbation", number.in("lengths/time"), 0.05,
                                 "The velocity p in y of a wave p sin(k x) on both layers.", "0.05");
  Key<int> waves = key("wave_number", whole("a whole number, 1 to (N - 1)/2", 1), 1,
                       "The wave number k: a layer rolls up into as many vortices.", "1");
} const shear{
    {"initial.shear_layers", other_torus_start,
     "Two layers between which the fluid runs to the left and beyond which it runs to the right, at y = "
     "pi/2 and 3 pi/2, with a wave on them: they roll up (Kelvin and Helmholtz; Bell, Colella and Glaz, "
     "1989). In a layer with a radius of deformation the flow has this velocity.",
     "{ width = 0.2, perturbation = 0.05 }"}};

torus::TorusHarmonics read_shear_layers(TorusStateRequest const& in) {
  double const speed = shear.speed.read(in.file), width = shear.width.read_or(in.file, pi / 15),
               p = shear.perturbation.read(in.file);
  if (!(width >= 0.01 && width <= 1))
    shear.width.fail(in.file, fmt::format("a width from 0.01 to 1 is expected, found {}", width));
  int const k = shear.waves.read(in.file, wave_number(in.n));
  auto const f = harmonics_of_function(in.n, [&](double x, double y) {
    double const below = 1 / std::cosh((y - pi / 2) / width), above = 1 / std::cosh((y - 3 * pi / 2) / width);
    return -speed / width * (below * below - above * above) + p * k * std::cos(k * x);
  });
  if (in.gamma == 0) return f;
  torus::QuantizedTorus const torus(in.n);
  return torus::scaled(
      f, [&](int m, int n) { return m == 0 && n == 0 ? 1.0 : 1 - in.gamma / torus.eigenvalue(m, n); });
}

struct RandomTorusKeys : KeyTable {
  Key<int> first =
      key("first", whole("a whole number, 1 to last", 1), 1, "The first ring of wave numbers.", "4");
  Key<int> last = key("last", whole("a whole number, 1 to (N - 1)/2", 1), LeftOut{"8, or (N - 1)/2"},
                      "The last one.", "8");
  Key<double> slope =
      key("slope", number.called("an exponent, -100 to 100"), 0,
          "The energy in the ring of the wave number k is on average proportional to this power of k.", "-3");
  Key<double> energy = key("energy", number.called("a number, 0 or more").in("lengths^4/time^2"), 1,
                           "The energy of the flow.", "1");
} const random_torus{
    {"initial.random", other_torus_start,
     "Random coefficients, normally distributed, from scene.seed: those of a wave number depend "
     "on nothing else, so that another N has the same flow.",
     "{ first = 4, last = 8 }"}};

/// Two numbers of the normal distribution that belong to a seed and a wave vector (Steele, Lea and Flood's
/// mixing; Box and Muller): the same ones in whatever order they are asked for.
std::complex<double> normal_pair(long seed, int m, int n) {
  auto const mixed = [](std::uint64_t z) {
    z += 0x9e3779b97f4a7c15, z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9,
                             z = (z ^ (z >> 27)) * 0x94d049bb133111eb;
    return z ^ (z >> 31);
  };
  std::uint64_t key = mixed(static_cast<std::uint64_t>(seed));
  key = mixed(key ^ static_cast<std::uint32_t>(m)), key = mixed(key ^ static_cast<std::uint32_t>(n));
  auto const uniform = [&](std::uint64_t k) {
    return (static_cast<double>(mixed(key + k) >> 11) + 0.5) * 0x1p-53;
  };
  return std::polar(std::sqrt(-2 * std::log(uniform(1))), 2 * pi * uniform(2));
}

torus::TorusHarmonics read_random(TorusStateRequest const& in) {
  auto const& keys = random_torus;
  int const last = keys.last.read_or(in.file, std::min(8, (in.n - 1) / 2), wave_number(in.n)),
            first = keys.first.read(in.file, Patterns::whole("", 1, last));
  double const slope = keys.slope.read(in.file), wanted = keys.energy.read(in.file);
  if (!(std::abs(slope) <= 100))
    keys.slope.fail(in.file, fmt::format("an exponent from -100 to 100 is expected, found {}", slope));
  if (!(wanted >= 0)) keys.energy.fail(in.file, fmt::format("a number >= 0 is expected, found {}", wanted));
  torus::QuantizedTorus const torus(in.n);
  torus::TorusHarmonics f(in.n);
  for (int n = 0; n <= last; ++n)
    for (int m = n == 0 ? 1 : -last; m <= last; ++m) {
      long const ring = std::lround(std::hypot(m, n));
      if (ring < first || ring > last) continue;
      // About 2 pi k wave vectors share the energy of a ring.
      double const share = std::pow(static_cast<double>(ring) / first, slope) / static_cast<double>(ring);
      f.set(m, n, std::sqrt(share * (in.gamma - torus.eigenvalue(m, n))) * normal_pair(in.seed, m, n));
    }
  double const found = torus::energy_by_ring(f, in.gamma).sum();
  if (!(found > 0)) keys.energy.fail(in.file, "the flow has none that could be scaled");
  f.coefficient *= std::sqrt(wanted) / std::sqrt(found);
  return f;
}

/// A named state.
struct TorusState {
  char const* name;
  torus::TorusHarmonics (*read)(TorusStateRequest const& in);
};
constexpr TorusState torus_states[] = {
    {"taylor_green", read_taylor_green}, {"shear_layers", read_shear_layers}, {"random", read_random}};

}  // namespace

std::vector<std::string> names_of_torus_states() { return names_of(torus_states); }

std::vector<Parameter> parameters_of_torus_states() {
  return records_of({taylor_green, shear, random_torus});
}

torus::TorusHarmonics read_torus_state(std::string const& name, TorusStateRequest const& in) {
  for (auto const& state : torus_states)
    if (state.name == name) return state.read(in);
  throw std::logic_error("no such state");
}

}  // namespace actio::scene
