// Cells of fluid that turn beside one another: where the particles go, what becomes of a patch of dye, and
// the pressure that keeps its area, got in two ways.
//
// What is shown. In the steady flow of Taylor and Green a particle goes round its cell in a time that an
// elliptic integral gives. The motion alone tells the pressure: on the body as the multiplier of the
// constraint J = 1, from the material equation (8.9), integrated from particle to particle; in space from the
// velocity, by the equation of the pressure (8.14) with its slope at the walls. The two meet where the
// particles are. Read first. cells.hpp has the flow.
//
//   X  particle, its place at t = 0     y  place              P  pressure on the body
//   phi(t, X)  place of a particle      u  velocity in space  p  pressure in space
//
// Compiled at -O2: it takes many steps.
#include "actio/incompressible/ideal_fluid.hpp"
#include "actio/incompressible/incompressible_equations.hpp"
#include "actio/numbers/gauss_quadrature.hpp"
#include "book/plot.hpp"
#include "book/program.hpp"
#include "cells.hpp"
#include "cosine_series.hpp"

using namespace actio;
using std::numbers::pi;

// ---- 1. Particles on their paths, and the lines of equal pressure. The result is the largest distance of a
// particle from its place by elliptic functions.
double draw_paths(book::Plot& plot) {
  double worst = 0;
  for (double const k : {0.05, 0.3, 0.6, 0.85}) {
    double const period = period_of(k);
    std::vector<double> x, y, dots_x, dots_y;
    for (int i = 0; i <= 240; ++i) {
      Place const at = by_elliptic_functions(k, period * i / 240);
      x.push_back(at[0]), y.push_back(at[1]);
    }
    for (int i = 0; i * 0.5 < period; ++i) {
      Place const at = place_of(by_elliptic_functions(k, 0), i * 0.5);
      dots_x.push_back(at[0]), dots_y.push_back(at[1]);
      worst = std::max(worst, (at - by_elliptic_functions(k, i * 0.5)).norm());
    }
    bool const named = k == 0.05;
    plot.curve(x, y, named ? "paths, by elliptic functions" : "", {.colour = 6, .width = 1.2});
    plot.dots(dots_x, dots_y, named ? "particles, every half unit of time" : "", {.colour = 1});
  }
  return worst;
}
// Isobars: cos 2 y1 + cos 2 y2 = c. Where one ends or turns back, the next point beyond closes it.
void draw_isobars(book::Plot& plot) {
  for (double const c : {-1.2, -0.4, 0.4, 1.2}) {
    std::vector<double> x, y;
    for (int branch = 0; branch < 2; ++branch) {
      for (int i = 0; i <= 400; ++i) {
        double const at = pi * i / 400, rest = c - std::cos(2 * at),
                     half = std::acos(std::clamp(rest, -1.0, 1.0)) / 2;
        x.push_back(at), y.push_back(std::abs(rest) > 1.016 ? NAN : branch ? pi - half : half);
      }
      x.push_back(NAN), y.push_back(NAN);
    }
    plot.curve(x, y, c == -1.2 ? "lines of equal pressure" : "", {.colour = 2, .width = 1, .dashed = true});
  }
}
void show_paths(book::Program& program) {
  auto plot = book::Plot("y1", "y2").equal().size(560, 560);
  double const worst = draw_paths(plot);
  draw_isobars(plot);
  program.picture("paths", plot.svg(),
                  "One cell: particles on their paths, and the lines of equal pressure, which is highest "
                  "in the corners and lowest in the middle.");
  program.figure("path_error", worst, "largest distance of a particle from its place by elliptic functions");
  program.claim(book::measured(worst) < 1e-10, "particles are where elliptic functions have them");
}

// ---- 2. The edge of a patch of dye at four times.
void show_dye(book::Program& program) {
  auto plot = book::Plot("y1", "y2").equal().size(560, 560).x_range(0, pi).y_range(0, pi);
  double worst = 0;
  for (double const t : {0.0, 2.0, 4.0, 8.0}) {
    std::vector<double> x, y;
    for (int i = 0; i <= 800; ++i) {
      double const turn = 2 * pi * i / 800;
      Place const X(1.1 + 0.45 * std::cos(turn), 1.1 + 0.45 * std::sin(turn)), at = place_of(X, t);
      x.push_back(at[0]), y.push_back(at[1]);
      if (i % 50 == 0) {
        auto const j = first_jet(Motion{}, Vector<double, 3>(t, X[0], X[1]));
        worst = std::max(worst, std::abs(VolumeConstraint{Euclidean<2>{}, Euclidean<2>{}}(j)[0]));
      }
    }
    plot.curve(x, y, "t = " + book::number(t));
  }
  program.picture("dye", plot.svg(),
                  "The edge of a patch of dye at four times: the constraint keeps its "
                  "area, and nothing keeps its shape.");
  program.figure("volume", worst, "largest deviation of J from 1 around the patch");
  program.claim(book::measured(worst) < 1e-9, "the motion preserves areas");
}

// ---- 3. The pressure of a particle less that of another: the multiplier's derivatives along the straight
// line between them on the body.
double multiplier_between(Place const& from, Place const& to, double t) {
  static auto const rule = gauss_quadrature<double>(24);
  auto const fluid =
      incompressible(Continuum{Euclidean<2>{}, Euclidean<2>{}, Homogeneous<double>{}, NoStoredEnergy{}});
  double sum = 0;
  for (std::size_t i = 0; i < rule.nodes.size(); ++i) {
    Place const X = from + rule.nodes[i] * (to - from);
    auto const j = second_jet(Motion{}, Vector<double, 3>(t, X[0], X[1]));
    sum += rule.weights[i] * required_pressure_gradient(fluid, j).dot(to - from);
  }
  return sum;
}
// The same in space: (8.14) in one cell, with no slope at the walls as the fluid asks there. And both beside
// the closed form.
void compare_pressures(book::Program& program) {
  auto const p = solve_poisson([](double y1, double y2) {
    return pressure_source(Euclidean<2>{}, Cells{}, Vector<double, 3>(0, y1, y2));
  });
  Place const first(0.7, 1.2);
  std::vector<book::Program::Row> rows;
  double by_multiplier = 0, by_poisson = 0;
  for (double const t : {0.0, 1.0, 2.0, 4.0})
    for (Place const& X : {Place(1.3, 0.8), Place(2.1, 2.4)}) {
      Place const here = place_of(first, t), there = place_of(X, t);
      double const exact = pressure_at(there) - pressure_at(here);
      double const multiplier = multiplier_between(first, X, t) - exact, poisson = p(there) - p(here) - exact;
      by_multiplier = std::max(by_multiplier, std::abs(multiplier)),
      by_poisson = std::max(by_poisson, std::abs(poisson));
      std::string const particle = "(" + book::number(X[0]) + ", " + book::number(X[1]) + ")";
      rows.push_back({book::number(t), particle, book::number(exact, 8), book::number(multiplier, 2),
                      book::number(poisson, 2)});
    }
  program.table("pressures", {"t", "particle", "pressure", "error by the multiplier", "error by (8.14)"},
                rows,
                "Pressure of a particle less that of the particle (0.7, 1.2): on the body by the "
                "multiplier, in space by the equation of the pressure.");
  program.figure("by_multiplier", by_multiplier, "largest error of the pressure by the multiplier");
  program.figure("by_poisson", by_poisson, "largest error of the pressure by (8.14)");
  program.claim(book::measured(by_multiplier) < 1e-7 && book::measured(by_poisson) < 1e-12,
                "the two pressures agree with the closed form");
  program.headline(
      "pressure by multiplier and by Poisson's equation agree to " + book::number(by_multiplier, 2),
      by_multiplier);
}

int main(int argc, char** argv) {
  book::Program program(
      argc, argv,
      "cells of fluid: paths by elliptic functions, a patch of dye, and the pressure by two ways");
  show_paths(program);
  show_dye(program);
  compare_pressures(program);
  return program.finish();
}
