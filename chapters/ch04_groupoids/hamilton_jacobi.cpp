// A book that turns over, by way of the Hamilton-Jacobi equation: generating functions of higher and higher
// order.
//
// What is shown. The Lie-Poisson Hamilton-Jacobi equation (4.1) of a free body is solved by a series in the
// step. Its first term is the discrete Lagrangian of the natural chart; each further one is a polynomial in
// the mean velocity and raises the order of the integrator (4.2), (4.3) by two, at no further equation to
// solve. However few terms are preserved, the momentum stays on its sphere. Read first. The section "The
// Hamilton-Jacobi route" of chapter 4.
//
//   I      principal moments, kg m^2                      S     generating function, J s
//   M      body momentum, kg m^2/s                        f     relative motion g1^-1 g0
//   l      Lagrangian of the free body, J                 h     step, s
#include "actio/groupoid/generating_series.hpp"
#include "actio/groups/rotations.hpp"
#include "book/measure.hpp"
#include "book/plot.hpp"
#include "witness/reference_solution.hpp"

using namespace actio;
using Vector3d = actio::Vector<double, 3>;

// Body momenta after 0, 1, ..., n steps of h with a generating function.
template <class S>
std::vector<Vector3d> momenta(S const& generating, Momentum<SO<3>, double> M,
                              Velocity<SO<3>, double> const& spin, double h, int n) {
  std::vector<Vector3d> path{M.components};
  auto f = exp(-h * spin);
  for (int k = 0; k < n; ++k) {
    auto const step = hamilton_jacobi_step_left(at_time(generating, h), M, f);
    M = step.final, f = step.g;
    path.push_back(M.components);
  }
  return path;
}

int main(int argc, char** argv) {
  book::Program program(argc, argv,
                        "a book turns over: generating functions from the Hamilton-Jacobi equation make "
                        "integrators of orders 2, 4, 6");

  // 1. A book of 0.8 kg, 24 cm high, 17 cm wide, 3 cm thick, thrown with two turns a second about its middle
  //    axis, a little off.
  double const mass = 0.8;
  Vector3d const size(0.17, 0.24, 0.03), squares = size.cwiseAbs2();
  Vector3d const moments =
      mass / 12 * Vector3d(squares[1] + squares[2], squares[0] + squares[2], squares[0] + squares[1]);
  // Ascending: axes 1, 2, 3 are the long one, the middle one, the one through the covers.
  Matrix<double, 3, 3> const I = Vector3d(moments[1], moments[0], moments[2]).asDiagonal();
  QuadraticLagrangian<SO<3>, double> const l(SO<3>{}, I);
  auto const spin = velocity(SO<3>{}, Vector3d(0.3, 4 * M_PI, 0.1));
  auto const M0 = l.momentum_of(spin);

  // 2. Generating functions with one, two and three terms; the terms between vanish.
  int const orders[] = {2, 4, 6};
  std::vector<GeneratingSeries<SO<3>, double>> series;
  for (int order : orders) series.push_back(generating_series(l, order - 2));
  program.say("the corrections are polynomials of ", series[2].sigma[2].terms.size(), " and ",
              series[2].sigma[4].terms.size(), " terms");

  // 3. Somebody else's solution of Euler's equations.
  auto const euler = [&](double, Vector3d const& M) { return Vector3d(cross(M, Vector3d(l.inverse_a * M))); };
  auto const exact = [&](double t) { return reference_solution(euler, M0.components, 0, t); };

  // 4. Six seconds by steps of a twelfth of a second, about sixty degrees each.
  double const until = 6, coarse = 1.0 / 12;
  int const steps_of_picture = 72;
  double const amount = M0.components.norm();
  auto plot = book::Plot("time, s", "momentum about the middle axis, part of the whole").y_range(-1.1, 1.1);
  std::vector<double> time, curve;
  for (int i = 0; i <= 900; ++i)
    time.push_back(until * i / 900), curve.push_back(exact(time.back())[1] / amount);
  plot.curve(time, curve, "Euler's equations", {.colour = 6, .width = 1.4});
  double off_sphere = 0;
  for (int i = 0; i < 3; ++i) {
    auto const path = momenta(series[i], M0, spin, coarse, steps_of_picture);
    std::vector<double> x, y;
    for (std::size_t k = 0; k < path.size(); ++k) {
      x.push_back(coarse * static_cast<double>(k)), y.push_back(path[k][1] / amount);
      off_sphere = std::max(off_sphere, std::abs(path[k].norm() / amount - 1));
    }
    plot.curve(x, y, "order " + std::to_string(orders[i]),
               {.colour = i + 1, .dots = true, .radius = 3.2 - 0.6 * i});
  }
  program.picture(
      "flip", plot.svg(),
      "A book thrown about its middle axis, by steps of a twelfth of a second: about sixty degrees each.");

  // 5. How the error falls.
  auto const end = exact(1.0);
  auto errors = book::Plot("step, s", "error of the momentum after one second, relative").log_x().log_y();
  std::vector<book::Program::Row> rows;
  std::vector<double> steps, misses[3];
  for (int n : {16, 24, 32, 40, 48, 64, 80, 96}) {
    steps.push_back(1.0 / n);
    rows.push_back({book::number(1.0 / n)});
    for (int i = 0; i < 3; ++i) {
      misses[i].push_back((momenta(series[i], M0, spin, 1.0 / n, n).back() - end).norm() / amount);
      rows.back().push_back(book::number(misses[i].back()));
    }
  }
  for (int i = 0; i < 3; ++i)
    errors.curve(steps, misses[i], "order " + std::to_string(orders[i]), {.colour = i + 1});
  program.picture("errors", errors.svg(),
                  "Error of the body momentum after one second with one, two and three terms of the "
                  "generating function.");
  program.table("errors", {"step, s", "one term", "two terms", "three terms"}, rows, "The same in numbers.");

  // 6. What must be so. A rounding error or two a step.
  for (int i = 0; i < 3; ++i) {
    // The two longest steps are too long for the leading term.
    double const order =
        book::exponent({steps.begin() + 2, steps.end()}, {misses[i].begin() + 2, misses[i].end()});
    program.figure("order" + std::to_string(orders[i]), order, book::number(order, 4),
                   "order with " + std::to_string(i + 1) + " term(s), fitted");
    program.claim(book::measured(std::abs(order - orders[i])) < 0.1,
                  "the order is " + std::to_string(orders[i]));
  }
  program.claim(book::measured(off_sphere) < 2 * steps_of_picture * 0x1p-52,
                "the momentum stays on its sphere to rounding");
  program.figure("sphere", off_sphere,
                 "largest change of the amount of the momentum at the coarse step, relative");
  double const gain = misses[0].back() / misses[2].back();
  program.figure("gain", gain, "error with one term over that with three, at the smallest step");
  program.headline(
      "two more terms of the generating function make the error " + book::number(gain, 2) + " times smaller",
      gain);
  return program.finish();
}
