// Newton's iteration on a group: find the element at which a covector vanishes.
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "actio/foundations/differential.hpp"

namespace actio {

/// What a solver did.
struct Report {
  int evaluations = 0;             ///< how often the residual (with its derivative) was evaluated
  std::vector<double> residuals;   ///< largest component of the residual at each iterate
  double tolerance = 0;            ///< the rounding level it had to come under
};

/// A solution and how it was found.
template <class T>
struct Solved {
  T value;
  Report report;
};

/// Solves residual(f) = 0 for f in G, starting from `start`.
///
/// Newton in the algebra: \f$f \leftarrow e^{\delta} f\f$ with \f$\delta\f$ from the exact derivative of the residual; `restore` once an update,
/// because products of many elements drift off the group.
/// It stops at 16 epsilon times the derivative's row norm: what one rounding error in f does to the residual, with 16 of them allowed for. It
/// also stops, satisfied, where the residual no longer falls within 64 times that level. The update at hand is applied all the same: it costs
/// no evaluation, and without it what is left of the residual would add up, step after step, in one direction. An update longer than 1 in the
/// algebra's coordinates is shortened to 1, so that a bad start does not leave the chart.
///
/// @param residual  element at any scalar -> covector at the same scalar
/// @throws Singular      where the derivative has no inverse: the Lagrangian is not regular there
/// @throws NotConverged  with the history of residuals, after `limit` iterations or where the residual grows without end
/// @throws NotFinite     where the residual is no number
template <ExponentialGroup G, Real S, class Residual>
Solved<Element<G, S>> solve_on_group(Residual const& residual, Element<G, S> const& start, int limit = 60) {
  int const n = start.group.dimension();
  Solved<Element<G, S>> found{start, {}};
  Report& report = found.report;
  Eigen::Matrix<S, G::dim, G::dim> derivative(n, n);
  Coordinates<G, S> value(n);

  for (int iteration = 0; iteration < limit; ++iteration) {
    // Evaluate the residual on elements moved infinitely little: value and derivative at once.
    over_batches(n, [&](int first) {
      auto const moved = residual(moved_left(found.value, first)).components;
      store_parts(derivative, moved, first);
      if (first == 0)
        for (int i = 0; i < n; ++i) value[i] = moved[i].value;
    });
    ++report.evaluations;
    if (!is_finite(value) || !is_finite(derivative)) throw NotFinite("solve_on_group: residual");

    double const size = to_double(magnitude(value));
    report.tolerance = 16 * to_double(epsilon<S>()) * row_norm(derivative);
    double const before = report.residuals.empty() ? size * 4 : report.residuals.back();
    report.residuals.push_back(size);
    bool const at_rounding = size <= report.tolerance || (size <= 64 * report.tolerance && size > before / 2);

    Coordinates<G, S> update = solve_linear(derivative, Coordinates<G, S>(-value), "solve_on_group: derivative of the residual");
    double const length = to_double(magnitude(update));
    if (length > 1) update /= S(Base<S>(length));
    found.value = restore(exp(Velocity<G, S>{start.group, update}) * found.value);
    if (at_rounding) return found;
  }
  throw NotConverged("solve_on_group", report.residuals, report.tolerance);
}

}  // namespace actio
