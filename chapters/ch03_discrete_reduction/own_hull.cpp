// A hull in still water: a Lagrangian of one's own in C++, and what becomes of three hulls.
//
// What is shown. A group and a Lagrangian are all that a system consists of; its equations, its steps and its
// conserved momentum follow. The water makes a long hull heavier sideways than ahead. Bow first it does not
// keep its course; broadside it does, and so does a hull that is heavier ahead, bow first. The same system is
// a scene (data/scenes/own_hull.toml) and a function of Python (data/scenes/own_hull.py).
// Read first. The page Your own system.
//
//   g     configuration in SE(2), hull to space     l     Lagrangian, of the velocity in the hull
//   xi    velocity: turning, ahead, sideways        h     step
//   c     mass sideways over mass ahead
//
// Compiled at -O2: it takes many steps.
#include <numbers>

#include "actio/groups/motions.hpp"
#include "actio/reduction/composition.hpp"
#include "actio/reduction/momentum_step.hpp"
#include "actio/reduction/natural_chart.hpp"
#include "book/plot.hpp"
#include "book/program.hpp"

using namespace actio;

// Where a hull was at equal times, the largest angle that it has turned by, and the change of its energy.
struct Voyage {
  std::vector<double> x, y, heading;
  double turned = 0, energy = 0;
};

// 1. The Lagrangian, a callable for every kind of number.
auto hull(double c) {
  return [c](auto const& xi) {
    auto const &w = xi.coordinates[0], &v1 = xi.coordinates[1], &v2 = xi.coordinates[2];
    return (w * w + v1 * v1 + v2 * v2 * c) / 2;
  };
}

// 2. Steps of order 4 from the momentum at the start, and the group element from its relative motions.
Voyage sail(double c, Vector<double, 3> const& start, double until = 20, double h = 0.01) {
  auto const l = hull(c);
  auto const step = ComposedLeft(natural_chart_step_left(l), suzuki<double>());
  auto const xi = velocity(SE<2>{}, start);
  auto state = momentum_state(l, xi);
  auto g = identity<double>(SE<2>{});
  Voyage out{{0}, {0}, {0}};
  double turned = 0, last = 0;
  for (long k = std::lround(until / h); k > 0; --k) {
    auto const done = step(state, h);
    g = reconstruct_left(g, done.relative_motion);
    state = done.state;
    double const heading = std::atan2(g.value(1, 0), g.value(0, 0));
    turned += std::remainder(heading - last, 2 * std::numbers::pi), last = heading;
    out.turned = std::max(out.turned, std::abs(turned) * 180 / std::numbers::pi);
    out.x.push_back(g.value(0, 2)), out.y.push_back(g.value(1, 2)), out.heading.push_back(heading);
  }
  // The energy as a function of the momentum, since the velocity of a step is one of its middle.
  auto const& m = state.momentum.components;
  out.energy = std::abs((m[0] * m[0] + m[1] * m[1] + m[2] * m[2] / c) / 2 / l(xi) - 1);
  return out;
}

// 3. The path, and the outline of the hull now and then: pointed at the bow, flat at the stern.
void draw(book::Plot& plot, Voyage const& voyage, std::string const& name, double length, int colour,
          double aside) {
  std::vector<double> y;
  for (double const v : voyage.y) y.push_back(v + aside);
  plot.curve(voyage.x, y, name, {.colour = colour, .width = 2});
  double const bow[][2] = {{0.5, 0}, {0.25, 0.12}, {-0.5, 0.12}, {-0.5, -0.12}, {0.25, -0.12}, {0.5, 0}};
  for (std::size_t k = 0; k < voyage.x.size(); k += 200) {
    std::vector<double> px, py;
    double const c = std::cos(voyage.heading[k]), s = std::sin(voyage.heading[k]);
    for (auto const& [a, b] : bow)
      px.push_back(voyage.x[k] + length * (c * a - s * b)), py.push_back(y[k] + length * (s * a + c * b));
    plot.curve(px, py, "", {.colour = colour, .width = 1.2});
  }
}

int main(int argc, char** argv) {
  book::Program program(argc, argv, "a hull in still water: which course does it keep?");
  Voyage const bow = sail(6, {0, 1, 0.001}), broadside = sail(6, {0, 0.001, 1}),
               blunt = sail(0.5, {0, 1, 0.001});
  for (auto const& [name, voyage] : {std::pair{"c = 6, bow first", &bow},
                                     {"c = 6, broadside", &broadside},
                                     {"c = 0.5, bow first", &blunt}})
    program.say(name, ": turned by ", book::number(voyage->turned), " degrees at most, energy changed by ",
                book::number(voyage->energy, 1));

  auto plot = book::Plot("x", "y").equal().size(660, 250);
  draw(plot, bow, "c = 6, bow first", 1.6, 1, 0);
  draw(plot, blunt, "c = 0.5, bow first", 1.6, 3, -3);
  program.picture("path", plot.svg(),
                  "Two hulls seen from above, at every second unit of time; the lower one starts at y = −3.");

  program.figure("turned", bow.turned, "angle by which the long hull turns, degrees");
  program.figure("broadside", broadside.turned, "the same broadside, degrees");
  program.claim(book::measured(bow.turned) > 170, "bow first the long hull swings round");
  program.claim(book::measured(broadside.turned) < 0.1, "broadside it keeps its course");
  program.claim(book::measured(blunt.turned) < 0.1,
                "a hull that is heavier ahead keeps its course bow first");
  program.claim(book::measured(std::max({bow.energy, broadside.energy, blunt.energy})) < 1e-8,
                "the energy changes by rounding and by the error of order 4");
  program.headline("bow first the hull turns by " + book::number(bow.turned) + " degrees", bow.turned);
  return program.finish();
}
