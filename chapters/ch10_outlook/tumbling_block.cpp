// A block of rubber is thrown, bends and tumbles: what a million steps of the scheme conserve.
//
// What is shown. A neo-Hookean block, free on all sides, with a velocity that turns it and bends it. Linear
// and angular momentum are those of the start to rounding, since the discrete Lagrangian has these
// symmetries. The energy is not conserved: it oscillates, with half the step a quarter as much, and with the
// longer step its mean drifts as well. Mean and deviation in each eighth of the run show it. Read first.
// Section 10B.7.
//
// Compiled at -O2: it takes many steps.
#include <numbers>

#include "actio/fast_media/fast_medium_2d.hpp"
#include "book/plot.hpp"
#include "book/program.hpp"
#include "eighths.hpp"

using namespace actio;
using namespace actio::media;
using Place = std::array<double, 2>;

// 1. The block: 2 by 1/2, sound crosses it in half a second.
constexpr int across = 32, up = 8;
constexpr double width = 2, high = 0.5, step = 0.004;
constexpr Place thrown{1.6, 2.0};  // the velocity of its centre in flight

auto block(double dt) {
  FastBox2d const box{{across, up},
                      {width / across, high / up},
                      {Side::free, Side::free},
                      {Side::free, Side::free},
                      {-width / 2, -high / 2}};
  auto const place = [](Place const& X) { return X; };
  // A turn about the centre, and a bending that changes its sign twice along the block.
  auto const velocity = [](Place const& X) {
    double const turn = 1.7, bend = 1.3 * std::cos(2 * std::numbers::pi * X[0] / width);
    return Place{-turn * X[1], turn * X[0] + bend};
  };
  return FastMedium2d(neo_hookean(12, 4), box, dt, 1, place, velocity);
}

// 2. What a long run conserves, seen from the centre: the largest changes of the energy and of the angular
//    momentum, relative, and of the linear momentum, which is zero, over mass and speed of the ends.
struct Kept {
  double energy = 0, momentum = 0, angular = 0;
  std::vector<double> times, band;
};
constexpr long samples = 1600;
Kept kept(double dt, long steps) {
  auto medium = block(dt);
  double const energy = medium.energy(), angular = medium.angular_momentum();
  double const size = 1.7 * width / 2;
  Kept out;
  long const between = steps / samples;
  for (long k = 0; k < steps; k += between) {
    medium.step(between);
    double const change = medium.energy() / energy - 1;
    auto const p = medium.momentum();
    out.energy = std::max(out.energy, std::abs(change));
    out.momentum = std::max(out.momentum, std::hypot(p[0], p[1]) / size);
    out.angular = std::max(out.angular, std::abs(medium.angular_momentum() / angular - 1));
    out.times.push_back(medium.time()), out.band.push_back(change);
  }
  return out;
}

// 3. The block in flight. A throw and its weight move every node alike, along a parabola: in the discrete
//    equations as well, where second differences of t and t^2 are exact. So they are added to the places.
std::string flight() {
  auto plot = book::Plot("x", "y").equal().size(660, 420);
  auto medium = block(step);
  auto const at = [&](std::vector<Place> const& x, int i, int j) {
    double const t = medium.time(), weight = 1.1;
    auto const& node = x[static_cast<std::size_t>(j * (across + 1) + i)];
    return Place{node[0] + thrown[0] * t, node[1] + thrown[1] * t - weight * t * t / 2};
  };
  for (int shown = 0; shown < 6; ++shown) {
    auto const x = medium.places();
    auto const line = [&](int i, int j, int di, int dj, int count, double pen) {
      std::vector<double> a, b;
      for (int k = 0; k <= count; ++k) {
        auto const p = at(x, i + k * di, j + k * dj);
        a.push_back(p[0]), b.push_back(p[1]);
      }
      plot.curve(a, b, "", {.colour = 1 + shown % 6, .width = pen});
    };
    for (int j = 0; j <= up; j += 4) line(0, j, 1, 0, across, j % up == 0 ? 1.8 : 0.7);
    for (int i = 0; i <= across; i += 4) line(i, 0, 0, 1, up, i % across == 0 ? 1.8 : 0.7);
    medium.step(static_cast<long>(0.75 / step));
  }
  return plot.svg();
}

// 4. The energy in eighths of the run: where the mean goes, in units of the oscillation about it.
void show_energy(book::Program& program, Kept const& run, Kept const& half) {
  Eighths const whole_step(run.band), half_step(half.band);
  show_eighths(program, whole_step, half_step, step);
  auto plot = book::Plot("time", "relative change of the energy");
  plot.curve(run.times, run.band, "step " + book::number(step))
      .curve(half.times, half.band, "step " + book::number(step / 2));
  program.picture("energy", plot.svg(),
                  "The energy with the step and with half of it. It oscillates; with the "
                  "longer step its mean drifts as well.");
  double const ratio = whole_step.oscillation / half_step.oscillation;
  program.claim(book::measured(std::abs(ratio - 4)) < 1, "half the step, a quarter of the oscillation");
  program.claim(book::measured(whole_step.deviation[7] / whole_step.deviation[1]) < 1.5,
                "the oscillation does not grow");
  program.claim(book::measured(std::abs(half_step.drift())) < 1,
                "with half the step the mean stays where it is, within the oscillation");
}

int main(int argc, char** argv) {
  book::Program program(argc, argv, "a block of rubber tumbles: momenta to rounding, the energy nearly");
  long const steps = 1000000;
  auto const run = kept(step, steps), half = kept(step / 2, 2 * steps);
  program.picture(
      "flight", flight(),
      "The block at six moments, three quarters of a unit of time apart: every fourth line of its mesh.");
  program.table("kept", {"step", "energy", "linear momentum", "angular momentum"},
                {{book::number(step), book::number(run.energy, 2), book::number(run.momentum, 2),
                  book::number(run.angular, 2)},
                 {book::number(step / 2), book::number(half.energy, 2), book::number(half.momentum, 2),
                  book::number(half.angular, 2)}},
                "Largest relative changes in a million steps, and in two million of half the length.");
  show_energy(program, run, half);
  program.figure("steps", steps, std::to_string(steps), "steps");
  program.figure("momentum", std::max(run.momentum, half.momentum), "change of the linear momentum");
  program.figure("angular", std::max(run.angular, half.angular), "change of the angular momentum");
  program.figure("energy", run.energy, "largest relative change of the energy");
  // Each step rounds each of some three hundred terms once or twice. As a random walk of two million steps
  // that is some five hundred roundings of the sum.
  program.claim(book::measured(std::max({run.momentum, run.angular, half.momentum, half.angular})) < 2.2e-13,
                "linear and angular momentum stay to rounding");
  program.headline("momenta within " + book::number(std::max(run.momentum, run.angular), 2) + " after " +
                       std::to_string(steps) + " steps",
                   std::max(run.momentum, run.angular));
  return program.finish();
}
