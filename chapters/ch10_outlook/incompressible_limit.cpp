// A tube of rubber rings: nearly incompressible, by a stiff volume, and incompressible, by a pressure.
//
// What is shown. The motion of an incompressible tube is known (Knowles). A compressible one comes near to it
// as its modulus kappa grows, like 1/kappa, in steps that get shorter like the root of it. But its energy is
// that of the Jacobians at the corners of cells, and these cannot all be one while the tube bends its cells:
// from some modulus on the mesh is too stiff. Cells with a pressure keep their area alone, with one step
// whatever the volume. Read first. Sections 10B.2 and 10C.3.
//
//   R, r    radius of a particle in the body and in space, r^2 = R^2 + s(t) for 1 <= R <= 2
//   kappa   modulus of the volume, in shear moduli
//
// Compiled at -O2: it takes many steps.
#include <array>

#include "actio/incompressible_media/incompressible_medium.hpp"
#include "actio/media_on_meshes/medium_on_mesh.hpp"
#include "actio/meshes/body_shapes.hpp"
#include "book/plot.hpp"
#include "book/program.hpp"

using namespace actio;
using namespace actio::media;
using book::measured, book::number;
using Place = std::array<double, 2>;

constexpr double kick = 0.8, until = 1;  // s' at the start, and the end

// 1. Knowles' equation for s, from the Lagrangian pi/8 s'^2 log(b/a) - U(s) with a = 1 + s, b = 4 + s.
double exact_s() {
  auto const rate = [](std::array<double, 2> const& y) {
    double const a = 1 + y[0], b = 4 + y[0], log = std::log(b / a), slope = 1 / b - 1 / a;
    double const pull = 4 * (std::log(4.0) - log - y[0] * slope);
    return std::array{y[1], -(y[1] * y[1] * slope + pull) / (2 * log)};
  };
  std::array y{0.0, kick};
  int const steps = 1000;
  double const h = until / steps;
  auto const plus = [](auto a, auto const& b, double by) { return a[0] += by * b[0], a[1] += by * b[1], a; };
  for (int k = 0; k < steps; ++k) {
    auto const a = rate(y), b = rate(plus(y, a, h / 2)), c = rate(plus(y, b, h / 2)), d = rate(plus(y, c, h));
    for (std::size_t i = 0; i < 2; ++i) y[i] += h / 6 * (a[i] + 2 * b[i] + 2 * c[i] + d[i]);
  }
  return y[0];
}

// 2. The tube at the start, and how far its nodes are from where they should be at the end, in the mean.
BodyMesh tube(int n) { return annulus_mesh(1, 2, {n, 4 * n}); }
Place struck(Place const& X) {
  double const out = kick / 2 / (X[0] * X[0] + X[1] * X[1]);
  return {out * X[0], out * X[1]};
}
template <class Medium>
double distance(Medium const& medium) {
  static double const s = exact_s();
  auto const x = medium.places();
  double sum = 0, mass = 0;
  for (std::size_t k = 0; k < x.size(); ++k) {
    auto const& X = medium.mesh().nodes[k];
    double const ratio = std::sqrt(1 + s / (X[0] * X[0] + X[1] * X[1]));
    double const far = std::hypot(x[k][0] - ratio * X[0], x[k][1] - ratio * X[1]);
    sum += medium.masses()[k] * far * far, mass += medium.masses()[k];
  }
  return std::sqrt(sum / mass);
}

// 3. Both roads: what is off, and in how many steps.
struct Run {
  double error;
  long steps;
};
Run stiff(int n, double kappa) {
  BodyStart<2> start;
  start.velocity = &struck;
  MediumOnMesh<2> rubber(tube(n), stored_energy<2>(FastNeoHookean{1, QuadraticLaw{1, kappa}}), start,
                         {.step = 1});
  auto const steps = static_cast<long>(std::ceil(until / (0.5 * rubber.largest_step())));
  rubber.set_time_step(until / static_cast<double>(steps));
  rubber.step(steps);
  return {distance(rubber), steps};
}
Run with_pressure(int n) {
  IncompressibleStart<2> start;
  start.velocity = &struck;
  long const steps = 4 * n;
  IncompressibleMedium<2> rubber(tube(n), stored_energy<2>(FastNeoHookean{1, QuadraticLaw{1, 0}}), start,
                                 until / static_cast<double>(steps));
  rubber.step(steps);
  return {distance(rubber), steps};
}

int main(int argc, char** argv) {
  book::Program program(argc, argv, "a tube of rubber, nearly incompressible and incompressible");
  std::vector<double> const moduli{10, 40, 160, 640, 2560, 10240};
  std::array const sizes{8, 16};
  auto plot = book::Plot("kappa", "distance from the incompressible motion").log_x().log_y().size(640, 400);
  std::vector<std::vector<Run>> runs;
  for (int const n : sizes) {
    std::vector<double> errors;
    runs.emplace_back();
    for (double const kappa : moduli)
      runs.back().push_back(stiff(n, kappa)), errors.push_back(runs.back().back().error);
    int const colour = n == 8 ? 1 : 2;
    plot.curve(moduli, errors, "stiff, " + std::to_string(n) + " cells across", {.colour = colour});
    double const exact = with_pressure(n).error;
    plot.curve(std::vector{moduli.front(), moduli.back()}, std::vector{exact, exact},
               "with pressure, " + std::to_string(n), {.colour = colour, .dashed = true});
  }
  Run const with = with_pressure(16);
  std::vector<book::Program::Row> rows;
  for (std::size_t k = 0; k < moduli.size(); ++k)
    rows.push_back({number(moduli[k]), number(runs[1][k].error, 2), std::to_string(runs[1][k].steps)});
  rows.push_back({"with pressure", number(with.error, 2), std::to_string(with.steps)});
  program.table(
      "limit", {"kappa", "distance", "steps"}, rows,
      "The tube on 16 x 64 cells at t = 1: distance from the incompressible motion, root mean square, and "
      "how many steps are half of the longest stable one.");
  program.picture("limit", plot.svg(), "How near a stiff volume comes to none.");
  double best = HUGE_VAL;
  for (Run const& run : runs[1]) best = std::min(best, run.error);
  double const gain = runs[1][0].error / runs[1][1].error;
  program.figure("gain", gain, number(gain, 2), "how much nearer a modulus of 40 is than one of 10");
  program.figure("with", with.error, number(with.error, 2), "distance with a pressure in each cell");
  program.figure("best", best, number(best, 2), "the least distance by a stiff volume");
  program.claim(measured(gain) > 3, "at first the distance falls like 1/kappa");
  program.claim(measured(runs[1].back().error / best) > 3, "then the corners of cells are too stiff");
  program.claim(measured(with.error / best) < 0.5, "cells with a pressure are nearer than any of these");
  program.headline("distance " + number(with.error, 2) + " with a pressure", with.error);
  return program.finish();
}
