// Newton's iteration on a group: find the element at which a covector vanishes.
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "actio/groups/differential.hpp"

namespace actio {

/// What a solver did.
struct Report {
  int evaluations = 0;  ///< how often the residual (with its derivative) was evaluated
  /// at each iterate, the largest component of the residual relative to its row of the derivative
  std::vector<double> residuals;
  double tolerance = 0;  ///< the rounding level they had to come under
};

/// A solution and how it was found.
template <class T>
struct Solved {
  T value;
  Report report;
};

/// Largest |value_i| / sum_j |derivative_ij|: the residual in units of motion in the group, whatever its
/// components' units are.
template <MatrixLike V, MatrixLike M>
double relative_residual(V const& value, M const& derivative) {
  using S = typename V::Scalar;
  double largest = 0;
  for (Index i = 0; i < value.size(); ++i) {
    S row(0);
    for (Index j = 0; j < derivative.cols(); ++j) row += magnitude(S(derivative(i, j)));
    S const size = magnitude(S(value[i]));
    if (size > S(0)) largest = std::max(largest, row > S(0) ? to_double(S(size / row)) : HUGE_VAL);
  }
  return largest;
}

/// By how much a velocity turns or stretches: \f$\sqrt{|\mathrm{tr}(\mathrm{ad}_\xi^2)|}/2\f$, about the
/// angle in SO(3) and SE(3).
///
/// No translation has any, so it does not depend on the unit of length; nor has any velocity of a nilpotent
/// group, whose exponential is a polynomial.
template <Group G, Scalar S>
double turning_size(Velocity<G, S> const& xi) {
  auto const ad = ad_matrix(xi);
  double trace = 0;
  for (Index i = 0; i < ad.rows(); ++i)
    for (Index j = 0; j < ad.cols(); ++j) trace += to_double(S(ad(i, j))) * to_double(S(ad(j, i)));
  return std::sqrt(std::abs(trace)) / 2;
}

/// Solves residual(f) = 0 for f in G, starting from `start`.
///
/// Newton in the algebra: \f$f \leftarrow e^{\delta} f\f$ with \f$\delta\f$ from the exact derivative of the
/// residual; `restore` once an update, because products of many elements drift off the group. It stops where
/// each component of the residual is within 16 epsilon of its row of the derivative: what one rounding error
/// in f does to it, with 16 of them allowed for. It also stops, satisfied, where the residual no longer falls
/// within 64 times that level. The update that the last derivative gives costs nothing more and is made too.
/// An update that turns by more than 1 is shortened to 1 (\ref turning_size), so that a bad start does not
/// leave the chart; one that only shifts is not, whatever the unit of length.
///
/// \snippet numbers.cpp solve_on_group
/// @param residual  element at any scalar -> covector at the same scalar
/// @throws Singular      where the derivative has no inverse, at a solution too: the Lagrangian is not
///                       regular there
/// @throws NotConverged  with the history of residuals, after `limit` iterations or where the residual grows
///                       beyond all numbers
/// @throws NotFinite     where the residual at `start` is no number
template <ExponentialGroup G, Real S, class Residual>
Solved<Element<G, S>> solve_on_group(Residual const& residual, Element<G, S> const& start, int limit = 60) {
  int const n = start.group.dimension();
  require_finite(start.value, "solve_on_group: start");
  Solved<Element<G, S>> found{start, {}};
  Report& report = found.report;
  report.residuals.reserve(8);
  report.tolerance = 16 * to_double(epsilon<S>());
  Matrix<S, G::dim, G::dim> derivative(n, n);
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
    if (!is_finite(value) || !is_finite(derivative)) {
      if (iteration == 0) throw NotFinite("solve_on_group: residual or its derivative");
      throw NotConverged("solve_on_group", report.residuals, report.tolerance);
    }

    double const before = report.residuals.empty() ? HUGE_VAL : report.residuals.back();
    double const size = relative_residual(value, derivative);
    report.residuals.push_back(size);
    bool const done = size <= report.tolerance || (size <= 64 * report.tolerance && size > before / 2);

    Coordinates<G, S> update =
        solve_linear(derivative, Coordinates<G, S>(-value), "solve_on_group: derivative of the residual");
    if (auto const length = magnitude(update); to_double(length) > 1) {
      double const turn = to_double(length) * turning_size(Velocity<G, S>{start.group, update / S(length)});
      if (turn > 1) update /= S(Base<S>(turn));
    }
    found.value = restore(exp(Velocity<G, S>{start.group, update}) * found.value);
    if (done) return found;
  }
  throw NotConverged("solve_on_group", report.residuals, report.tolerance);
}

}  // namespace actio
