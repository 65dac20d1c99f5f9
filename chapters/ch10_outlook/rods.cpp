// Rods: the equation of a rigid body, (3.11), once in time and once along a line.
//
// What is shown. A rod that is bent and let go keeps linear and angular momentum to rounding, and its energy
// oscillates with the square of the step. The flying rod of Simo and Vu-Quoc, with the parameters that Hante
// and others use, is computed with 40, 80 and 160 elements; the error has order 2. A slender rod without
// stretch and shear may take steps that are many times as long. Read first. Sections 10G.1 and 10G.2.
//
//   h  step     n  number of elements     m  strength of the load
//
// Compiled at -O2: it takes many steps.
#include <numbers>

#include "actio/rods/rod.hpp"
#include "actio/rods/step_limit.hpp"
#include "book/measure.hpp"
#include "book/plot.hpp"

using namespace actio::rods;
using Vector = Three<double>;

// 1. A rod that is straight at rest, begins bent to a screw, and flies free.
struct Flight {
  double momentum, energy;  // largest change of momenta, and of the energy, relatively
};
Flight let_go(double step, double time) {
  RodSection const section{{60, 25, 20}, {0.5, 0.8, 0.7}, 1.2, {0.06, 0.03, 0.04}};
  auto const straight = RodShape::of_strains(3, 20, {0, 0, 0}, {1, 0, 0, 0}),
             screw = RodShape::of_strains(3, 20, {0, 0, 0}, {1, 0, 0, 0}, [](double) {
               return Vector{0.3, 0.8, -0.5};
             });
  RodStart start{screw, {}, {}};
  for (auto const& x : screw.places) start.velocity.push_back({0.2 - 0.3 * x[1], 0.3 * x[0], 0.1});
  Rod rod(section, straight, start, {}, {step});
  auto const energy = [&] {
    auto const now = rod.energies(rod.frame());
    return now.kinetic + now.strain;
  };
  auto const before = rod.momentum();
  double const first = energy();
  Flight out{0, 0};
  while (rod.time() < time) {
    rod.step(10);
    auto const now = rod.momentum();
    for (std::size_t i = 0; i < 3; ++i)
      out.momentum = std::max({out.momentum, std::abs(now.linear[i] - before.linear[i]),
                               std::abs(now.angular[i] - before.angular[i])});
    out.energy = std::max(out.energy, std::abs(energy() / first - 1));
  }
  return out;
}

// 2. The flying rod: 10 long, pushed and turned at one end until t = 5.
struct Flown {
  std::vector<std::vector<Vector>> shapes;  // at some times
  Vector loaded, free;                      // its ends at the last of them
  double energy;                            // after the load
};
Flown fly(int elements, bool unshearable, std::vector<double> const& times) {
  RodSection const section{{1e4, 1e4, 1e4}, {500, 500, 500}, 1, {10, 10, 10}};
  double const tilt = std::atan2(8, -6);
  auto const shape =
      RodShape::of_strains(10, elements, {6, 0, 0}, {std::cos(tilt / 2), 0, 0, std::sin(tilt / 2)});
  RodLoads loads;
  auto const m = [](double t) { return t < 2.5 ? 80 * t : t < 5 ? 80 * (5 - t) : 0; };
  loads.start.force = [=](double t) { return Vector{m(t) / 10, 0, 0}; };
  loads.start.moment = [=](double t) { return Vector{0, -m(t) / 2, -m(t)}; };
  Rod rod(section, shape, {shape, {}, {}}, loads, {0.08 / elements, unshearable});
  Flown out;
  for (double const t : times) {
    rod.step(std::lround(t * elements / 0.08) - rod.steps());
    out.shapes.push_back(rod.frame().places);
  }
  auto const energies = rod.energies(rod.frame());
  out.loaded = out.shapes.back().front(), out.free = out.shapes.back().back();
  out.energy = energies.kinetic + energies.strain;
  return out;
}
double distance(Vector const& a, Vector const& b) {
  return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
}
std::string in_words(Vector const& a) {
  return book::number(a[0], 7) + ", " + book::number(a[1], 6) + ", " + book::number(a[2], 6);
}

// 3. A slender rod, a thousand times as long as its radius: how long steps may be.
double longest(bool unshearable) {
  auto const thin = RodSection::circular(1e-3, 1e7, 0.25, 1000);
  auto const shape = RodShape::of_strains(1, 50, {0, 0, 0}, {1, 0, 0, 0});
  return longest_rod_step(Rod(thin, shape, {shape, {}, {}}, {}, {1e-6, unshearable}).constants(),
                          unshearable);
}

int main(int argc, char** argv) {
  book::Program program(argc, argv, "rods: the equation of a body, once in time and once along a line");
  Flight const coarse = let_go(0.01, 200), fine = let_go(0.005, 200);
  double const slope = std::log2(coarse.energy / fine.energy);
  program.figure("momentum", std::max(coarse.momentum, fine.momentum),
                 "largest change of a component of linear and angular momentum of a free rod");
  program.figure("energy", fine.energy, "largest relative change of the energy, h = 0.005");
  program.figure("energy_slope", slope, "its order in the step");
  program.claim(book::measured(fine.momentum) < 1e-12, "a free rod keeps both momenta to rounding");
  program.claim(book::measured(std::abs(slope - 2)) < 0.2,
                "its energy oscillates with the square of the step");

  std::vector<Flown> flown;
  std::vector<std::vector<std::string>> rows;
  std::vector<double> const times{0, 2.5, 4, 5, 7.5, 10, 12.5, 15};
  for (int const n : {40, 80, 160}) flown.push_back(fly(n, false, times));
  auto const extrapolated = [&](auto const& part) {
    Vector out;
    for (std::size_t i = 0; i < 3; ++i)
      out[i] = part(flown[2])[i] + (part(flown[2])[i] - part(flown[1])[i]) / 3;
    return out;
  };
  auto const loaded = [](Flown const& one) { return one.loaded; };
  auto const end = [](Flown const& one) { return one.free; };
  for (std::size_t k = 0; k < 3; ++k)
    rows.push_back({std::to_string(40 << k), in_words(flown[k].loaded), in_words(flown[k].free),
                    book::number(flown[k].energy, 7)});
  double const energy = flown[2].energy + (flown[2].energy - flown[1].energy) / 3;
  rows.push_back(
      {"extrapolated", in_words(extrapolated(loaded)), in_words(extrapolated(end)), book::number(energy, 7)});
  program.table("flight", {"n", "loaded end", "other end", "energy"}, rows, "The flying rod at t = 15.");
  // By another implementation, extrapolated from n = 20 to 160.
  Vector const other{69.36494, 2.19593, -2.54196}, other_end{61.37770, 6.01528, 1.98270};
  double const apart =
                   std::max(distance(extrapolated(loaded), other), distance(extrapolated(end), other_end)),
               order = std::log2(distance(flown[0].loaded, flown[1].loaded) /
                                 distance(flown[1].loaded, flown[2].loaded));
  program.figure("apart", apart, "distance of the extrapolated ends from those of another implementation");
  program.figure("order", order, book::number(order, 4), "order of the place of the loaded end");
  program.claim(book::measured(apart) < 1e-4, "extrapolated ends agree with those of another implementation");
  program.claim(book::measured(std::abs(order - 2)) < 0.03, "the flying rod converges with order 2");

  auto plot = book::Plot("x", "y").size(640, 260);
  for (std::size_t k = 0; k < times.size(); ++k) {
    std::vector<double> x, y;
    for (auto const& one : flown[1].shapes[k]) x.push_back(one[0]), y.push_back(one[1]);
    plot.curve(x, y, "t = " + book::number(times[k]));
  }
  program.picture("flight", plot.svg(), "A flying rod, seen along the third axis.");
  Flown const stiff[] = {fly(40, true, {15}), fly(80, true, {15}), fly(160, true, {15})};
  double const stiff_order =
      std::log2(distance(stiff[0].loaded, stiff[1].loaded) / distance(stiff[1].loaded, stiff[2].loaded));
  program.figure("unshearable_order", stiff_order, book::number(stiff_order, 4),
                 "order without stretch and shear");
  program.claim(book::measured(std::abs(stiff_order - 2)) < 0.03,
                "so does the one without stretch and shear");

  double const free = longest(false), held = longest(true);
  program.figure("free_step", free, "longest step of a slender rod");
  program.figure("held_step", held, "the same without stretch and shear");
  program.figure("longer", held / free, "their ratio");
  program.headline("momenta kept to " + book::number(fine.momentum), fine.momentum);
  return program.finish();
}
