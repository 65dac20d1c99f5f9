// A book that turns over, by way of the Hamilton-Jacobi equation: generating functions of higher and higher
// order.
//
// What is shown. The Lie-Poisson Hamilton-Jacobi equation (4.1) of a free body is solved by a series in the
// step. Its first term is the discrete Lagrangian of the natural chart; each further one is a polynomial in
// the mean velocity and raises the order of the integrator (4.2), (4.3) by two, at no further equation to
// solve. However few terms are taken, the momentum stays on its sphere. Read first. The section "The
// Hamilton-Jacobi equation solved by a series" of chapter 4A.
//
//   I      principal moments, kg m^2                      S     generating function, J s
//   M      body momentum, kg m^2/s                        f     relative motion g1^-1 g0
//   l      Lagrangian of the free body, J                 h     step, s
#include "actio/groupoid/generating_series.hpp"
#include "actio/groups/rotations.hpp"
#include "book/measure.hpp"
#include "book/plot.hpp"
#include "running_examples.hpp"
#include "witness/reference_solution.hpp"

using namespace actio;
using Vector3d = actio::Vector<double, 3>;
using Series = GeneratingSeries<SO<3>, double>;
int const orders[] = {2, 4, 6};

// 1. The book of the running example, thrown with two turns a second about its middle axis, a little off.
struct Throw {
  QuadraticLagrangian<SO<3>, double> l{SO<3>{}, Matrix<double, 3, 3>(book_inertia.asDiagonal())};
  Velocity<SO<3>, double> spin = velocity(SO<3>{}, Vector3d(0.3, 4 * M_PI, 0.1));
  Momentum<SO<3>, double> M0 = l.momentum_of(spin);
  double amount = M0.components.norm();
};

// 2. Generating functions with one, two and three terms; the terms between vanish.
std::vector<Series> generating_functions(Throw const& thrown) {
  std::vector<Series> all;
  for (int order : orders) all.push_back(generating_series(thrown.l, order - 2));
  return all;
}

// 3. Body momenta after 0, 1, ..., n steps of h with a generating function; and, as a reference, Euler's
//    equations solved by somebody else.
std::vector<Vector3d> momenta(Series const& generating, Throw const& thrown, double h, int n) {
  auto M = thrown.M0;
  auto f = exp(-h * thrown.spin);
  std::vector<Vector3d> path{M.components};
  for (int k = 0; k < n; ++k) {
    auto const step = hamilton_jacobi_step_left(at_time(generating, h), M, f);
    M = step.final, f = step.g;
    path.push_back(M.components);
  }
  return path;
}
Vector3d exact(Throw const& thrown, double t) {
  auto const euler = [&](double, Vector3d const& M) {
    return Vector3d(cross(M, Vector3d(thrown.l.inverse_a * M)));
  };
  return reference_solution(euler, thrown.M0.components, 0, t);
}

// 4. Six seconds by steps of a twelfth of a second, about sixty degrees each.
void turn_over(book::Program& program, Throw const& thrown, std::vector<Series> const& series) {
  double const until = 6, h = 1.0 / 12;
  int const count = 72;
  auto plot = book::Plot("time, s", "momentum about the middle axis, part of the whole").y_range(-1.1, 1.1);
  std::vector<double> time, curve;
  for (int i = 0; i <= 900; ++i)
    time.push_back(until * i / 900), curve.push_back(exact(thrown, time.back())[1] / thrown.amount);
  plot.curve(time, curve, "Euler's equations", {.colour = 6, .width = 1.4});
  double off_sphere = 0;
  for (int i = 0; i < 3; ++i) {
    auto const path = momenta(series[i], thrown, h, count);
    std::vector<double> x, y;
    for (std::size_t k = 0; k < path.size(); ++k) {
      x.push_back(h * static_cast<double>(k)), y.push_back(path[k][1] / thrown.amount);
      off_sphere = std::max(off_sphere, std::abs(path[k].norm() / thrown.amount - 1));
    }
    plot.curve(x, y, "order " + std::to_string(orders[i]),
               {.colour = i + 1, .dots = true, .radius = 3.2 - 0.6 * i});
  }
  program.picture(
      "flip", plot.svg(),
      "A book thrown about its middle axis, by steps of a twelfth of a second: about sixty degrees each.");
  program.claim(book::measured(off_sphere) < 2 * count * 0x1p-52,
                "the momentum stays on its sphere to rounding");
  program.figure("sphere", off_sphere,
                 "largest change of the magnitude of the momentum at the coarse step, relative");
}

// 5. How the error falls, and what must be so: the orders. The two longest steps are too long for the leading
//    term.
void let_the_step_shrink(book::Program& program, Throw const& thrown, std::vector<Series> const& series) {
  auto const end = exact(thrown, 1.0);
  std::vector<book::Program::Row> rows;
  std::vector<double> steps, misses[3];
  for (int n : {16, 24, 32, 40, 48, 64, 80, 96}) {
    steps.push_back(1.0 / n);
    rows.push_back({book::number(1.0 / n)});
    for (int i = 0; i < 3; ++i) {
      misses[i].push_back((momenta(series[i], thrown, 1.0 / n, n).back() - end).norm() / thrown.amount);
      rows.back().push_back(book::number(misses[i].back()));
    }
  }
  auto errors = book::Plot("step, s", "error of the momentum after one second, relative").log_x().log_y();
  for (int i = 0; i < 3; ++i) {
    errors.curve(steps, misses[i], "order " + std::to_string(orders[i]), {.colour = i + 1});
    double const order =
        book::exponent({steps.begin() + 2, steps.end()}, {misses[i].begin() + 2, misses[i].end()});
    program.figure("order" + std::to_string(orders[i]), order, book::number(order, 4),
                   "order with " + std::to_string(i + 1) + " term(s), fitted");
    program.claim(book::measured(std::abs(order - orders[i])) < 0.1,
                  "the order is " + std::to_string(orders[i]));
  }
  program.picture("errors", errors.svg(),
                  "Error of the body momentum after one second with one, two and three "
                  "terms of the generating function.");
  program.table("errors", {"step, s", "one term", "two terms", "three terms"}, rows, "The same in numbers.");
  double const gain = misses[0].back() / misses[2].back();
  program.figure("gain", gain, "error with one term over that with three, at the smallest step");
  program.headline(
      "two more terms of the generating function make the error " + book::number(gain, 2) + " times smaller",
      gain);
}

int main(int argc, char** argv) {
  book::Program program(argc, argv,
                        "a book turns over: generating functions from the Hamilton-Jacobi equation "
                        "make integrators of orders 2, 4, 6");
  Throw const thrown;
  auto const series = generating_functions(thrown);
  program.say("the corrections are polynomials of ", series[2].sigma[2].terms.size(), " and ",
              series[2].sigma[4].terms.size(), " terms");
  turn_over(program, thrown, series);
  let_the_step_shrink(program, thrown, series);
  return program.finish();
}
