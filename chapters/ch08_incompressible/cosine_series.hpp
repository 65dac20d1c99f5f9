// Poisson's equation in a square by cosines: the sum of second derivatives is given in the square from 0 to
// pi, and the slope at its walls is zero.
#pragma once

#include <cmath>
#include <numbers>

#include "actio/numbers/scalar.hpp"

// The sum of c[a][b] cos(a y1) cos(b y2), whose slope at the walls is zero term by term.
struct CosineSeries {
  static constexpr int modes = 12;
  double c[modes][modes] = {};
  double operator()(actio::Vector<double, 2> const& y) const {
    double sum = 0;
    for (int a = 0; a < modes; ++a)
      for (int b = 0; b < modes; ++b) sum += c[a][b] * std::cos(a * y[0]) * std::cos(b * y[1]);
    return sum;
  }
};

// The solution of mean zero for a source, `source(y1, y2)`: its coefficients are sums over nodes in the
// middle of even intervals.
template <class Source>
CosineSeries solve_poisson(Source const& source) {
  CosineSeries p;
  int const modes = CosineSeries::modes, count = 2 * modes;
  auto const node = [&](int i) { return std::numbers::pi * (i + 0.5) / count; };
  for (int i = 0; i < count; ++i)
    for (int k = 0; k < count; ++k) {
      double const here = source(node(i), node(k));
      for (int a = 0; a < modes; ++a)
        for (int b = a == 0; b < modes; ++b)
          p.c[a][b] -= here * std::cos(a * node(i)) * std::cos(b * node(k)) * (a ? 2 : 1) * (b ? 2 : 1) /
                       (count * count) / (a * a + b * b);
    }
  return p;
}
