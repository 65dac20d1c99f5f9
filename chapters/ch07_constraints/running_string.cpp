// Strings that cannot stretch: the multiplier is the tension, and it comes out of where the string is and how
// it moves.
//
// What is shown. A string that runs along itself keeps its shape, whatever the shape is, and the tension is
// the mass per length times the speed squared. Hung up, a string is a catenary; set running it stays one,
// with the same added to its tension. Both are exact solutions of the constrained field equations, n = 1,
// N = 2. The tension is found again from the field equations at single points, and from a boundary value
// problem that takes position and velocity alone. Read first. The chapter up to the extended bundle;
// strings.hpp, the strings; tensions.hpp, what the equations make of a tension.
//
//   s      length along the string, m            rho    mass per length, kg/m
//   phi    position, m                           T      tension, N: the multiplier of (1 - |phi_s|^2)/2
//   X      shape, by arc length                  v      speed along itself, m/s
#include "book/measure.hpp"
#include "book/plot.hpp"
#include "book/program.hpp"
#include "strings.hpp"
#include "tensions.hpp"

using namespace actio;
using Points = std::vector<double>;

double const rho = 0.05, gravity = 9.81, end = 1.6;  // the chains reach from s = -end to end
Running<Loop> const loop{{3, 0.9}, 6, rho};
Running<Catenary> const still{{1}, 0, rho}, swift{{1}, 10, rho};

// ---- 1. A loop in free space that runs along itself, and a chain that hangs between two points, at rest and
// running from one to the other.
std::string picture_of_loop() {
  double const l = loop.X.length;
  auto plot = book::Plot("x, m", "y, m").equal().size(560, 470);
  Points x, y;
  for (int i = 0; i <= 400; ++i) {
    auto const p = loop.X.place(l * i / 400);
    x.push_back(p[0]), y.push_back(p[1]);
  }
  plot.curve(x, y, "the string, at all times", {.colour = 6});
  for (int k = 0; k < 3; ++k) {
    Points u, w;
    for (int i = 0; i < 6; ++i) {
      auto const p = loop(Event<double, 1>(0.05 * k, l * i / 24));
      u.push_back(p[0]), w.push_back(p[1]);
    }
    plot.dots(u, w, "six of its points after " + book::number(0.05 * k) + " s",
              {.colour = k + 1, .radius = 4.0 - 0.7 * k});
  }
  return plot.svg();
}
std::string picture_of_swift() {
  auto plot = book::Plot("x, m", "tension, N").size(560, 360);
  for (double v : {0.0, 5.0, 10.0}) {
    Tension<Catenary> const tension{{swift.X, v, rho}, gravity};
    Points x, T;
    for (int i = 0; i <= 200; ++i) {
      double const s = -end + 2 * end * i / 200;
      x.push_back(swift.X(s)[0]), T.push_back(tension.at(0, s));
    }
    plot.curve(x, T, v == 0 ? "at rest" : "running at " + book::number(v) + " m/s");
  }
  return plot.svg();
}

// ---- 2. The residual of the strings, and of two with a tension that is wrong. The result is
// the residual of those that run.
double show_equations(book::Program& program) {
  double const l = loop.X.length;
  Tension<Loop> const of_loop{loop, 0}, half{loop, 0, 0.5};
  Tension<Catenary> const of_still{still, gravity}, of_swift{swift, gravity}, of_rest{swift, gravity, 0};
  double const left[] = {residual(of_loop, 0, l), residual(of_still, -end, end),
                         residual(of_swift, -end, end)};
  double const error[] = {apart(of_loop, 0, l), apart(of_still, -end, end), apart(of_swift, -end, end)};
  double const slack = residual(half, 0, l), forgotten = residual(of_rest, -end, end);
  auto const cell = [](double value) { return book::number(value, 2); };
  program.table("residuals", {"string", "equations and constraint", "tension from the equations"},
                {{"loop that runs", cell(left[0]), cell(error[0])},
                 {"chain at rest", cell(left[1]), cell(error[1])},
                 {"chain that runs", cell(left[2]), cell(error[2])},
                 {"loop with half the tension", cell(slack), "–"},
                 {"chain that runs, with the tension of rest", cell(forgotten), "–"}},
                "Residual of the field equations, over the largest force in them, and the relative error "
                "of the tension found at single points. The last two are controls.");
  program.claim(book::measured(std::max({left[0], left[1], left[2]})) < 1e-12,
                "the field equations and the constraint hold to rounding");
  program.claim(book::measured(std::max({error[0], error[1], error[2]})) < 1e-10,
                "the tension found at single points is the exact one");
  program.claim(book::measured(std::min(slack, forgotten)) > 0.1,
                "a wrong tension leaves a force as large as those in balance");
  return std::max(left[0], left[2]);
}

// ---- 3. The largest relative error of the tension found from position and velocity alone: at points s round
// the loop, or along the chain.
double error_round(Points const& s) {
  double worst = 0;
  for (double const T : tension_from_boundary_values(loop, s, true))
    worst = std::max(worst, std::abs(T / (rho * loop.v * loop.v) - 1));
  return worst;
}
double error_along(Points const& s) {
  Tension<Catenary> const exact{swift, gravity};
  Points const T = tension_from_boundary_values(swift, s, false, exact.at(0, -end), exact.at(0, end));
  double worst = 0;
  for (std::size_t i = 0; i < s.size(); ++i) worst = std::max(worst, std::abs(T[i] / exact.at(0, s[i]) - 1));
  return worst;
}
void show_boundary_values(book::Program& program) {
  Points round(200), steps, errors;
  for (std::size_t i = 0; i < round.size(); ++i) round[i] = loop.X.length * static_cast<double>(i) / 200;
  for (int count = 15; count < 300; count = 2 * count + 1) {
    double const h = 2 * end / (count + 1);
    Points s;
    for (int i = 1; i <= count; ++i) s.push_back(-end + h * i);
    steps.push_back(h), errors.push_back(error_along(s));
  }
  double const worst = error_round(round), order = book::exponent(steps, errors);
  program.figure("round", worst, "relative error of the loop's tension, found from its place and velocity");
  program.figure("order", order, "order at which the chain's tension is found so");
  program.figure("finest", errors.back(), "relative error on the finest grid");
  program.claim(book::measured(worst) < 1e-10 && book::measured(std::abs(order - 2)) < 0.1,
                "place and velocity give the tension, to second order in the grid");
}

int main(int argc, char** argv) {
  book::Program program(
      argc, argv,
      "a string that cannot stretch: it runs along itself in any shape, and its tension is the multiplier");
  std::string const speed = book::number(loop.v) + " m/s.";
  program.picture("loop", picture_of_loop(),
                  "A loop of string in free space. It stands still and its points run round it at " + speed);
  program.picture("chain", picture_of_swift(),
                  "The tension of a chain along a catenary, at rest and running. Its shape is the same.");

  double const left = show_equations(program), pull = rho * loop.v * loop.v;
  program.figure("loop_tension", pull, book::number(pull) + " N", "tension of the loop");
  program.figure("closes", loop.X.place(loop.X.length).norm(), "gap of the loop, m");
  show_boundary_values(program);

  program.headline("strings that run, with equations and constraint to " + book::number(left, 2), left);
  return program.finish();
}
