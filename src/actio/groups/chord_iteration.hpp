// The chord iteration on a group: Newton's iteration with a derivative that is reused from one equation to
// the next.
//
// The equations of successive steps of an integrator differ little, and so do the derivatives of their
// residuals. One of them, inverted once, serves many steps; each iteration corrects it along its own
// direction by Broyden's formula, which takes a few products. All that is evaluated is the residual
// itself, with first-order dual numbers in place of second-order ones. Where the iteration contracts too
// slowly the derivative is evaluated anew, and where it fails Newton's iteration (solve.hpp) has
// the last word: on the solution, and on what is thrown where there is none.
#pragma once

#include <optional>

#include "actio/groups/solve.hpp"

namespace actio {

/// Solves one equation residual(f) = 0 on G after another, each near the last in its derivative.
///
/// The solution is that of \ref solve_on_group to rounding, and is judged as there: each component of the
/// residual within 16 epsilon of its row of the derivative, here the stored one. One object serves one
/// thread; copies are independent.
///
/// Over plain numbers: infinitesimals need derivatives at the solution (solve.hpp).
template <ExponentialGroup G, Real S>
class ChordIteration {
 public:
  /// The solution near `start`.
  ///
  /// @param residual  element at any scalar -> covector at the same scalar
  /// @param start     where the chord iteration starts
  /// @param safe      where Newton's iteration starts if the chord iteration fails
  /// @throws Singular, NotConverged, NotFinite  as \ref solve_on_group from `safe`
  template <class Residual>
  Element<G, S> solve(Residual const& residual, Element<G, S> const& start, Element<G, S> const& safe) {
    static_assert(Plain<S>, "infinitesimals need the derivative at the solution: solve_on_group");
    std::optional<Element<G, S>> found;
    try {
      found = iterate(residual, start);
    } catch (Error const&) {
      // Newton's iteration says what is wrong, if anything is.
    }
    by_newton_ = !found;
    if (found) return *found;
    known_ = false;
    auto solved = solve_on_group(residual, safe);
    report_ = std::move(solved.report);
    return solved.value;
  }
  /// The solution near `start`.
  template <class Residual>
  Element<G, S> solve(Residual const& residual, Element<G, S> const& start) {
    return solve(residual, start, start);
  }

  /// Whether Newton's iteration had to solve the last equation.
  bool by_newton() const { return by_newton_; }
  /// By how much the last solution differs from its start, \f$f \approx e^vf_{start}\f$, as far as the steps
  /// of the iteration commute. Not where Newton's iteration has found it.
  Coordinates<G, S> const& moved() const { return moved_; }
  /// How the last equation was solved.
  Report const& report() const { return report_; }
  /// How often a derivative was evaluated, since the beginning.
  long derivatives() const { return derivatives_; }
  /// Forgets the derivative, for instance because an equation of another kind comes next.
  void forget() { known_ = false; }

 private:
  // An iteration that leaves more than this of the residual asks for a new derivative.
  static constexpr double slow_ = 0.125;
  static constexpr int limit_ = 20;

  template <class Residual>
  std::optional<Element<G, S>> iterate(Residual const& residual, Element<G, S> const& start) {
    require_finite(start.value, "chord iteration: start");
    report_.residuals.clear();
    report_.evaluations = 0;
    report_.tolerance = 16 * to_double(epsilon<S>());
    Element<G, S> f = start;
    Coordinates<G, S> value, last;
    moved_ = Coordinates<G, S>::Zero(f.group.dimension());
    bool newton = !known_;  // whether the last step was one of Newton's
    if (newton)
      value = evaluate_derivative(residual, f);
    else
      value = evaluate(residual, f);
    double before = HUGE_VAL;
    for (int iteration = 0; iteration < limit_; ++iteration) {
      if (!is_finite(value)) return {};
      double size = relative_size(value);
      report_.residuals.push_back(size);
      bool const done = size <= report_.tolerance || (size <= 64 * report_.tolerance && size > before / 2);
      Coordinates<G, S> step = -(inverse_ * value);
      if (!done && size > slow_ * before) {
        if (newton && size > before / 2) return {};
        value = evaluate_derivative(residual, f);
        newton = true;
        step = -(inverse_ * value);
      } else if (iteration > 0) {
        newton = false;
        if (!done) improve(last, step);
      }
      if (!(to_double(magnitude(step)) <= 1)) return {};
      f = exp(Velocity<G, S>{f.group, step}) * f;
      moved_ += step;
      if (done) return restore(f);
      last = step;
      before = size;
      value = evaluate(residual, f);
    }
    return {};
  }

  template <class Residual>
  Coordinates<G, S> evaluate(Residual const& residual, Element<G, S> const& f) {
    ++report_.evaluations;
    return residual(f).components;
  }
  /// The residual with its derivative, whose inverse is stored.
  template <class Residual>
  Coordinates<G, S> evaluate_derivative(Residual const& residual, Element<G, S> const& f) {
    int const n = f.group.dimension();
    Coordinates<G, S> value(n);
    Matrix<S, G::dim, G::dim> derivative(n, n);
    over_batches(n, [&](int first) {
      auto const moved = residual(moved_left(f, first)).components;
      store_parts(derivative, moved, first);
      if (first == 0)
        for (int i = 0; i < n; ++i) value[i] = moved[i].value;
    });
    ++report_.evaluations;
    ++derivatives_;
    per_row_ = Coordinates<G, S>::Zero(n);
    for (int i = 0; i < n; ++i) {
      for (int j = 0; j < n; ++j) per_row_[i] += magnitude(derivative(i, j));
      per_row_[i] = S(1) / per_row_[i];
    }
    inverse_ = inverse_matrix(derivative, "chord iteration: derivative of the residual");
    known_ = true;
    return value;
  }
  double relative_size(Coordinates<G, S> const& value) const {
    S largest(0);
    for (Index i = 0; i < value.size(); ++i) {
      S const size = magnitude(value[i]) * per_row_[i];
      if (size > largest) largest = size;
    }
    return to_double(largest);
  }
  /// Broyden's formula: after a step s the next one would be s' with the old inverse B; the inverse that
  /// agrees with what s did to the residual is \f$B + s's^TB/(|s|^2 - \langle s,s'\rangle)\f$. Turns s' into
  /// its step.
  void improve(Coordinates<G, S> const& s, Coordinates<G, S>& next) {
    S const square = s.squaredNorm(), rest = square - s.dot(next);
    if (!(rest > square / S(2))) return;
    int const n = static_cast<int>(s.size());
    for (int j = 0; j < n; ++j) {
      S const factor = s.dot(inverse_.col(j)) / rest;
      for (int i = 0; i < n; ++i) inverse_(i, j) += next[i] * factor;
    }
    next *= square / rest;
  }

  Matrix<S, G::dim, G::dim> inverse_;
  Coordinates<G, S> per_row_;
  Coordinates<G, S> moved_;
  bool known_ = false;
  bool by_newton_ = false;
  long derivatives_ = 0;
  Report report_;
};

}  // namespace actio
