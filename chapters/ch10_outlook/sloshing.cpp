// Water sloshes in a tank: weight that acts on cells, and weight that acts on nodes.
//
// What is shown. The lowest wave in a tank has the frequency of linear theory, omega^2 = g k tanh(k H), with
// an error of second order, and a pressure that is hydrostatic at rest to rounding. With the same weight at
// the nodes, equal to first order, shears of neighbouring columns grow exponentially, faster on finer cells.
// Read first. Section 10C.4.
//
//   g, H, k   gravity, depth, wave number pi over the length, which is 1
//
// Compiled at -O2: it takes many steps.
#include <array>
#include <numbers>

#include "actio/incompressible_media/incompressible_medium.hpp"
#include "book/plot.hpp"
#include "book/program.hpp"

using namespace actio;
using namespace actio::media;
using book::measured, book::number;
using std::numbers::pi;

constexpr double g = 9.81, depth = 0.7, wave_number = pi;
double const theory = std::sqrt(g * wave_number * std::tanh(wave_number * depth));

// 1. The tank, in the lowest wave of small amplitude as it passes through rest.
struct Tank {
  int across, up;
  double amplitude = 1e-4;
  bool at_nodes = false;

  double step() const { return 2 * pi / theory / (4 * across); }
  IncompressibleMedium<2> water() const {
    IncompressibleStart<2> start;
    double const c = amplitude * theory / std::sinh(wave_number * depth);
    start.velocity = [c](auto const& X) {
      double const x = wave_number * X[0], y = wave_number * X[1];
      return std::array{-c * std::cosh(y) * std::sin(x), c * std::sinh(y) * std::cos(x)};
    };
    start.project = true;
    BodyLoads<2> loads;
    if (at_nodes)
      loads.potentials.push_back(space_potential<2>([](auto const& x) { return x[1] * g; }));
    else
      start.gravity = {0, -g};
    return {box_mesh({0, 0}, {1, depth}, {across, up}),
            {},
            start,
            step(),
            {{"left", {Side::sliding, {}}}, {"right", {Side::sliding, {}}}, {"bottom", {Side::sliding, {}}}},
            loads};
  }
};

// 2. The frequency, from where the mode on the surface is zero: five periods.
double frequency(Tank const& tank) {
  auto water = tank.water();
  auto const mode = [&] {
    auto const x = water.places();
    double sum = 0;
    for (int i = 0; i <= tank.across; ++i) {
      auto const node = static_cast<std::size_t>(tank.up * (tank.across + 1) + i);
      double const share = i == 0 || i == tank.across ? 0.5 : 1;
      sum += share * std::cos(pi * i / tank.across) * (x[node][1] - depth);
    }
    return sum;
  };
  std::vector<double> zeros;
  double last = mode();
  for (int k = 1; k <= 5.3 * 4 * tank.across; ++k) {
    water.step();
    double const now = mode();
    if (k > 1 && (now > 0) != (last > 0)) zeros.push_back((k - 1 + last / (last - now)) * tank.step());
    last = now;
  }
  return pi * static_cast<double>(zeros.size() - 1) / (zeros.back() - zeros.front());
}

// 3. How far the pressure at rest is from g (H - y).
double hydrostatic(Tank tank) {
  tank.amplitude = 0;
  auto water = tank.water();
  water.step(100);
  double most = 0;
  auto const P = water.pressures();
  for (std::size_t k = 0; k < P.size(); ++k) {
    double const row = static_cast<double>(k / static_cast<std::size_t>(tank.across));
    most = std::max(most, std::abs(P[k] - g * depth * (1 - (row + 0.5) / tank.up)));
  }
  return most;
}

// 4. The largest |J - 1| at a corner of a cell over time.
struct Growth {
  std::vector<double> time, deformation;
  double rate = 0;  // of its logarithm in the last third
};
Growth growth(Tank const& tank, double until) {
  Growth out;
  auto water = tank.water();
  while (water.time() < until) {
    try {
      water.step(tank.across / 2);
    } catch (Error const&) {
      break;  // it has grown until a cell folded
    }
    double most = 0;
    for (double const J : water.jacobians()) most = std::max(most, std::abs(J - 1));
    out.time.push_back(water.time()), out.deformation.push_back(most);
  }
  std::size_t const end = out.time.size() - 1, from = end * 2 / 3;
  out.rate = std::log(out.deformation[end] / out.deformation[from]) / (out.time[end] - out.time[from]);
  return out;
}

int main(int argc, char** argv) {
  book::Program program(argc, argv, "water in a tank: weight of cells and weight of nodes");
  std::vector<book::Program::Row> rows;
  double before = 0, off = 0, order = 0;
  for (auto const& [across, up] : {std::pair{16, 11}, {32, 22}, {64, 45}}) {
    off = frequency({across, up}) / theory - 1;
    order = before != 0 ? std::log2(before / off) : 0;
    rows.push_back({std::to_string(across) + " x " + std::to_string(up), number(100 * off, 3) + " %",
                    before != 0 ? number(order, 3) : ""});
    before = off;
  }
  program.table("frequency", {"cells", "frequency", "order"}, rows,
                "The lowest wave: its frequency beside that of linear theory.");
  double const rest = hydrostatic({16, 11});
  auto plot = book::Plot("t", "largest |J - 1|").log_y().size(640, 360);
  double slow = 0, fast = 0, cells = 0;
  for (int const n : {8, 16}) {
    int const up = n == 8 ? 6 : 11;
    auto const nodes = growth({n, up, 1e-4, true}, 5);
    (n == 8 ? slow : fast) = nodes.rate;
    plot.curve(nodes.time, nodes.deformation, "at nodes, " + std::to_string(n) + " cells",
               {.colour = n == 8 ? 1 : 2});
    auto const whole = growth({n, up}, 5);
    cells = std::max(cells, whole.deformation.back());
    plot.curve(whole.time, whole.deformation, "of cells, " + std::to_string(n) + " cells",
               {.colour = n == 8 ? 3 : 4});
  }
  program.picture(
      "growth", plot.svg(),
      "Deformation of the corners of cells by a wave of amplitude 1e-4: weight at nodes, and of cells.");
  program.figure("off", off, number(100 * std::abs(off), 2), "per cent of the frequency on 64 x 45 cells");
  program.figure("rest", rest, number(rest, 2), "difference from the hydrostatic pressure");
  program.figure("slow", slow, number(slow, 2), "rate of growth with weight at nodes, 8 cells across");
  program.figure("fast", fast, number(fast, 2), "rate of growth with weight at nodes, 16 cells across");
  program.claim(measured(std::abs(off)) < 2e-4, "the frequency is that of gravity waves");
  program.claim(measured(std::abs(order - 2)) < 0.25, "its error is of second order");
  // Volumes are off by 2e-13, and h^2 times minus the Laplacian of the pressure is as much at most.
  double const step = Tank{16, 11}.step(), allowed = 2e-13 * depth * depth / 2 / (step * step);
  program.claim(measured(rest) < allowed, "water at rest has hydrostatic pressure, as volumes are kept");
  program.claim(measured(cells) < 1e-2, "with weight of cells corners are deformed as by the wave");
  program.claim(measured(slow) > 1, "with weight at nodes shears grow");
  program.claim(measured(fast / slow) > 1, "and faster on finer cells");
  program.headline("frequency off by " + number(100 * std::abs(off), 2) + " %", off);
  return program.finish();
}
