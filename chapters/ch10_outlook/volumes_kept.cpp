// Fluids that keep the area of every cell: cells that turn in a box, and a flow on the sphere.
//
// What is shown. The steady flow of Taylor and Green and its pressure are known. Cells that keep their areas
// follow it with errors of second order, in places and, though the pair of four nodes and one pressure is not
// stable for Stokes' equations, in pressures. On the sphere a steady flow of degree 2 is followed with three
// angular momenta at rounding. Further on in the shear of the first flow a cell folds, while area, energy and
// momenta look perfect. Read first. ch08_taylor_green, section 10C.3.
//
//   n   cells along a side, or along an edge of the cube that is blown up to the sphere
//   P   pressure of a cell, at the time of the places
//
// Compiled at -O2: it takes many steps.
#include <array>
#include <numbers>

#include "actio/incompressible_media/incompressible_medium.hpp"
#include "actio/incompressible_media/incompressible_sphere.hpp"
#include "book/plot.hpp"
#include "book/program.hpp"
#include "ch08_incompressible/cells.hpp"

using namespace actio;
using namespace actio::media;
using book::measured, book::number;
using std::numbers::pi;

// 1. The box of cells, whose walls are slid along.
IncompressibleMedium<2> turning(int n) {
  IncompressibleStart<2> start;
  start.velocity = [](auto const& X) {
    auto const u = Cells{}(Vector<double, 3>(0, X[0], X[1]));
    return std::array{u[0], u[1]};
  };
  BodySides<2> walls;
  for (char const* side : {"left", "right", "bottom", "top"}) walls[side] = {Side::sliding, {}};
  return {box_mesh({0, 0}, {pi, pi}, {n, n}), {}, start, 0.25 / n, walls};
}

// 2. A run to t = 1, and what is off then: root mean squares.
struct Run {
  double place = 0, pressure = 0, volume = 0, energy = 0;
};
template <class Medium, class Exact, class Pressure>
Run compared(Medium& fluid, long steps, Exact const& exact, Pressure const& pressure) {
  Run out;
  double const E = fluid.kinetic_energy();
  for (long k = 0; k < steps; ++k) fluid.step(), out.volume = std::max(out.volume, fluid.volume_defect());
  auto const x = fluid.places();
  double mass = 0, mean = 0, square = 0;
  for (std::size_t k = 0; k < x.size(); ++k) {
    auto const there = exact(fluid.mesh().nodes[k]);
    for (std::size_t a = 0; a < x[k].size(); ++a)
      out.place += fluid.masses()[k] * std::pow(x[k][a] - there[a], 2);
    mass += fluid.masses()[k];
  }
  // Pressures are known up to a constant.
  auto const P = fluid.pressures();
  auto const cells = static_cast<double>(P.size());
  for (std::size_t k = 0; k < P.size(); ++k) {
    auto middle = x[0];
    for (std::size_t a = 0; a < middle.size(); ++a) {
      middle[a] = 0;
      for (int b = 0; b < 4; ++b) middle[a] += x[static_cast<std::size_t>(fluid.mesh().cells[k][b])][a] / 4;
    }
    double const off = P[k] - pressure(middle);
    mean += off / cells, square += off * off / cells;
  }
  out.place = std::sqrt(out.place / mass), out.pressure = std::sqrt(square - mean * mean);
  out.energy = std::abs(fluid.kinetic_energy() / E - 1);
  return out;
}
Run cells_on(int n) {
  auto fluid = turning(n);
  return compared(
      fluid, 4 * n, [](auto const& X) { return place_of(Place(X[0], X[1]), 1); },
      [](auto const& y) { return pressure_at(Place(y[0], y[1])); });
}

// 3. The sphere: psi = xy/2 + 3yz/10, of degree 2, u = x cross grad psi, p = -|u|^2/2 - 3 psi^2.
using Point = std::array<double, 3>;
Point slope(Point const& x) { return {x[1] / 2, x[0] / 2 + 0.3 * x[2], 0.3 * x[1]}; }
Point wind(Point const& x) {
  Point const g = slope(x);
  return {x[1] * g[2] - x[2] * g[1], x[2] * g[0] - x[0] * g[2], x[0] * g[1] - x[1] * g[0]};
}
Point carried(Point x) {
  int const steps = 200;
  double const h = 1.0 / steps;
  auto const plus = [](Point a, Point const& b, double by) {
    for (std::size_t k = 0; k < 3; ++k) a[k] += by * b[k];
    return a;
  };
  for (int k = 0; k < steps; ++k) {
    Point const a = wind(x), b = wind(plus(x, a, h / 2)), c = wind(plus(x, b, h / 2)),
                d = wind(plus(x, c, h));
    for (std::size_t i = 0; i < 3; ++i) x[i] += h / 6 * (a[i] + 2 * b[i] + 2 * c[i] + d[i]);
  }
  return x;
}
struct OnSphere {
  Run run;
  double turn;  // change of the angular momentum
};
OnSphere sphere_on(int n) {
  IncompressibleSphere air(sphere_mesh(n), &wind, 1.0 / (8 * n));
  Point const before = air.angular_momentum();
  OnSphere out{compared(air, 8 * n, &carried,
                        [](Point p) {
                          double const size = std::hypot(p[0], p[1], p[2]);
                          for (double& one : p) one /= size;
                          Point const u = wind(p), g = slope(p);
                          double const psi = (p[0] * g[0] + p[1] * g[1] + p[2] * g[2]) / 2;
                          return -(u[0] * u[0] + u[1] * u[1] + u[2] * u[2]) / 2 - 3 * psi * psi;
                        }),
               0};
  Point const after = air.angular_momentum();
  for (std::size_t a = 0; a < 3; ++a) out.turn = std::max(out.turn, std::abs(after[a] - before[a]));
  return out;
}

// 4. Finer and finer meshes.
struct Refined {
  std::vector<Run> runs;
  double place = 0, pressure = 0;  // orders between the two finest
};
template <class On>
Refined refined(book::Program& program, std::string const& name, std::vector<int> const& sizes, On const& on,
                std::string const& caption) {
  Refined out;
  std::vector<book::Program::Row> rows;
  for (int const n : sizes) {
    out.runs.push_back(on(n));
    Run const& now = out.runs.back();
    auto const order = [&](double Run::*error) {
      return out.runs.size() < 2 ? 0.0 : std::log2(out.runs.end()[-2].*error / now.*error);
    };
    out.place = order(&Run::place), out.pressure = order(&Run::pressure);
    auto const shown = [&](double value) { return out.runs.size() < 2 ? std::string() : number(value, 3); };
    rows.push_back({std::to_string(n), number(now.place, 3), shown(out.place), number(now.pressure, 3),
                    shown(out.pressure), number(now.volume, 2), number(now.energy, 2)});
  }
  program.table(name, {"n", "places", "order", "pressures", "order", "volume", "energy"}, rows, caption);
  return out;
}

// 5. How far it goes: a cell at a corner of the box folds.
struct Folding {
  double time = 0, volume = 0, energy = 0;
};
Folding until_it_folds(int n) {
  auto fluid = turning(n);
  double const E = fluid.kinetic_energy();
  try {
    fluid.step(16L * n);
  } catch (CellFolds const& folds) {
    return {folds.time, fluid.volume_defect(), std::abs(fluid.kinetic_energy() / E - 1)};
  }
  return {};
}

// How far air goes that turns once in the time 2 pi.
double sphere_until_it_folds(int n) {
  IncompressibleSphere air(
      sphere_mesh(n),
      [](Point const& x) {
        return Point{-x[1], x[0], 0};
      },
      1.0 / (8 * n));
  try {
    air.step(48L * n);
  } catch (CellFolds const& folds) {
    return folds.time;
  }
  return HUGE_VAL;
}

// 6. The cells at a time, and their pressures as widths of their edges would hide them: the mesh alone.
std::string picture() {
  auto plot = book::Plot("x", "y").equal().size(520, 520);
  auto fluid = turning(24);
  fluid.step(96 * 3 / 2);
  auto const x = fluid.places();
  constexpr int around[] = {0, 1, 3, 2, 0};
  for (auto const& cell : fluid.mesh().cells) {
    std::vector<double> a, b;
    for (int const corner : around) a.push_back(x[cell[corner]][0]), b.push_back(x[cell[corner]][1]);
    plot.curve(a, b, "", {.colour = 1, .width = 0.7});
  }
  return plot.svg();
}

int main(int argc, char** argv) {
  book::Program program(argc, argv, "fluids that keep the area of every cell");
  auto const box =
      refined(program, "box", {8, 16, 32, 64}, &cells_on,
              "Cells that turn in a box, t = 1: root mean squares of what places and pressures are off "
              "by; the largest change of the area of a cell, over it; the change of the energy.");
  double turn = 0;
  auto const sphere = refined(
      program, "sphere", {4, 8, 16},
      [&](int n) {
        auto const one = sphere_on(n);
        turn = std::max(turn, one.turn);
        return one.run;
      },
      "A steady flow of degree 2 on the sphere, t = 1.");
  double volume = 0;
  for (auto const* part : {&box.runs, &sphere.runs})
    for (Run const& run : *part) volume = std::max(volume, run.volume);
  std::vector<book::Program::Row> rows;
  double latest = 0;
  for (int const n : {8, 16, 32}) {
    Folding const fold = until_it_folds(n);
    rows.push_back({std::to_string(n), number(fold.time, 4), number(fold.volume, 2), number(fold.energy, 2)});
    latest = fold.time;
  }
  program.table("folding", {"n", "a cell folds at", "volume", "energy"}, rows,
                "When a corner of a cell turns inside out, and what volumes and energy say just before.");
  program.picture("mesh", picture(),
                  "The cells of the box at t = 3/2. All have the area that they began with.");
  program.figure("place_order", box.place, number(box.place, 3), "order of places in the box");
  program.figure("pressure_order", box.pressure, number(box.pressure, 3), "order of pressures in the box");
  program.figure("volume", volume, number(volume, 2), "largest change of the area of a cell, over it");
  program.figure("turn", turn, number(turn, 2), "change of the angular momentum on the sphere");
  program.figure("sphere_order", sphere.place, number(sphere.place, 3), "order of places on the sphere");
  program.claim(measured(std::abs(box.place - 2)) < 0.06 && measured(std::abs(box.pressure - 2)) < 0.06,
                "places and raw pressures have order 2");
  program.claim(measured(volume) < 2e-13, "the area of each cell is kept at each step");
  program.claim(measured(turn) < 1e-13, "on the sphere three angular momenta are kept");
  program.claim(measured(sphere.place) > 1.75 && measured(std::abs(sphere.pressure - 2)) < 0.06,
                "on the whole sphere places have an order above 7/4, pressures 2");
  double const coarse = sphere_until_it_folds(8), fine = sphere_until_it_folds(16);
  program.figure("coarse_folds", coarse, number(coarse, 2), "when turning air on 8 cells folds");
  program.figure("fine_folds", fine, number(fine, 2), "when turning air on 16 cells folds");
  program.claim(measured(fine / coarse) < 1, "turning air folds the sooner the finer its cells");
  program.claim(latest > 0, "a cell folds in the shear");
  program.headline("order " + number(box.pressure, 3) + " of pressures", box.pressure);
  return program.finish();
}
