// What the programs that judge rival_maps.hpp have in common: the order of a map, the worst of a sample,
// how a defect is written, and the closed form of one.
#pragma once

#include "book/measure.hpp"
#include "book/program.hpp"
#include "rival_maps.hpp"
#include "witness/reference_solution.hpp"

namespace rivals {

// What rounding gives at most: a thousand epsilon.
constexpr double rounding = 1000 * 0x1p-52;

// A defect for a table; one that is rounding is 0.
inline std::string shown(double defect) {
  return defect < rounding ? "0 (" + book::number(defect, 1) + ")" : book::number(defect, 2);
}

// The largest of something over a sample.
template <class Points, class Defect>
double worst(Points const& points, Defect const& defect) {
  double largest = 0;
  for (auto const& x : points) largest = std::max(largest, defect(x));
  return largest;
}

// The order of a family: its distance from the flow after two seconds, for finer and finer steps.
template <class G>
double order(DiagonalBody<G> const& body, Family<Momentum, G> const& family,
             Momentum<G, double> const& start) {
  auto const rate = [&](double, auto const& y) {
    return Coordinates<G, double>(body.rate(momentum(start.group, y)).components);
  };
  auto const exact = reference_solution(rate, start.components, 0, 2);
  std::vector<double> steps, errors;
  for (int n = 20; n <= 320; n *= 2) {
    auto pi = start;
    for (int k = 0; k < n; ++k) pi = family(2.0 / n, pi);
    steps.push_back(2.0 / n), errors.push_back((pi.components - exact).norm());
  }
  return book::exponent(steps, errors);
}

// The Poisson defect of a step of the midpoint rule in closed form: with the derivative X' of the field
// Pi x Omega in the middle of the step.
inline double midpoint_defect(DiagonalBody<SO<3>> const& body, double h, Vector<double, 3> const& middle) {
  auto const field = [&](auto const& m) { return body.rate(momentum(SO<3>{}, m)).components; };
  Matrix<double, 3, 3> const X = derivative(field, middle).matrix;
  Matrix<double, 3, 3> const square = X * X, cube = square * X;
  double const minors = -square.trace() / 2, determinant = cube.trace() / 3;  // X has no trace
  return std::abs(determinant) * h * h * h / 8 / (1 + h * h / 4 * minors);
}

}  // namespace rivals
