// Reference solutions of differential equations by power series: y' = f(y) with as many terms as the digits
// of the scalar ask for. In 50 or 100 digits they are the reference solution that has nothing in common with
// the schemes it judges.
#pragma once

#include "actio/numbers/taylor.hpp"

namespace actio {

/// How many terms a scalar wants: where the work for a unit of time is least, (terms)^3 / (step) with a step
/// of (radius) epsilon^(1/terms).
template <Real S>
int taylor_terms() { return std::max(12, static_cast<int>(0.8 * decimal_digits<S>())); }

/// y(duration), where y' = f(y) and y(0) = `start`, by power series whose remainder is below rounding.
///
/// @param f         column of numbers -> its rate of change, callable at `Taylor<S>`; smooth along the
///                  solution
/// @param start     column of numbers
/// @param duration  time; negative to go back
/// @throws NotFinite      where f is no number
/// @throws OutsideDomain  where a step would be shorter than 1e-7 of the duration, which is what happens at a
///                        singularity: the time reached and the time asked for Accuracy: a few epsilon of the
///                        largest component for each step, magnified as the flow magnifies errors.
template <Real S, int n, class F>
Matrix<S, n, 1> taylor_reference(F const& f, Matrix<S, n, 1> const& start,
                                 std::type_identity_t<S> const& duration) {
  using std::log, std::exp;
  int const terms = taylor_terms<S>(), size = static_cast<int>(start.size());
  Matrix<S, n, 1> y = start;
  S reached(0);
  while (reached != duration) {
    require_finite(y, "taylor_reference");
    // Each evaluation of f on the series known so far gives one power more.
    Matrix<Taylor<S>, n, 1> series(size);
    for (int i = 0; i < size; ++i) series[i] = Taylor<S>::series({y[i]});
    std::vector<S> largest(terms + 1, S(0));
    for (int k = 0; k < terms; ++k) {
      Matrix<Taylor<S>, n, 1> const rate = f(series);
      for (int i = 0; i < size; ++i) {
        series[i].coefficients.push_back(rate[i].coefficient(k) / S(k + 1));
        series[i].order = k + 1;
      }
    }
    for (int k = 0; k <= terms; ++k)
      for (int i = 0; i < size; ++i) {
        S const c = magnitude(series[i].coefficients[k]);
        if (!is_finite(c)) throw NotFinite("taylor_reference: right side or one of its derivatives");
        if (c > largest[k]) largest[k] = c;
      }

    // The step at which the last two terms are below rounding of the largest component.
    S const rest = duration - reached;
    S step = rest < S(0) ? S(-rest) : rest;
    S const scale = largest[0] > S(0) ? largest[0] : S(largest[1] * step);
    for (int k = terms - 1; k <= terms; ++k)
      if (largest[k] > S(0) && scale > S(0)) {
        S const allowed = exp(S((log(scale) + log(S(epsilon<S>())) - log(largest[k])) / S(k)));
        if (allowed < step) step = allowed;
      }
    bool const last = step == rest || step == -rest;
    S const signed_step = rest < S(0) ? S(-step) : step;
    if (!last && step < (duration < S(0) ? S(-duration) : duration) / S(10000000))
      throw OutsideDomain("taylor_reference", "the solution must be smooth up to the end; time reached",
                          to_double(reached), to_double(duration));
    for (int i = 0; i < size; ++i) y[i] = series[i].at(signed_step);
    reached = last ? S(duration) : S(reached + signed_step);
  }
  require_finite(y, "taylor_reference");
  return y;
}

}  // namespace actio
