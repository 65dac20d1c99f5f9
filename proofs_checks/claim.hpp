// What a check claims about a statement of the thesis, and what was measured.
//
// A check calls `zero` or `equal` for what must vanish, `order` for a rate, and `refutes` or `differs` for the control: the same quantity with one hypothesis
// broken, one sign or one index flipped, which must not vanish. Everything that is measured goes to the ledger.
#pragma once

#include <cmath>
#include <cstdint>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "actio/foundations/draw.hpp"

namespace actio::checks {

/// One measured figure that speaks for a statement.
struct Evidence {
  std::string what, kind, scalar, model;
  double measured = 0, bound = 0, epsilon = 0;
  std::vector<double> steps, errors;
  double slope = 0, spread = 0;
  int degree = 0, points = 0;
  double probability = 0;
};
/// The same quantity with a hypothesis broken: it must stay above the floor.
struct Control {
  std::string what, scalar, model;
  double measured = 0, floor = 0;
  int points = 0;
};
/// All that one run of a check, over one scalar, says about its statement.
struct Record {
  std::string id, title, scalar, verdict, printed, corrected, note, source;
  bool scan = false;
  std::vector<Evidence> evidence;
  std::vector<Control> control;
  std::vector<std::string> failures;
  std::uint64_t seed = 0;
  double seconds = 0;
};

/// Numbers a quantity is made of: a scalar, a matrix, a velocity, a momentum, an element.
template <Field S>
Base<S> size_of(S const& x) {
  return magnitude(x);
}
template <class M>
auto size_of(Eigen::MatrixBase<M> const& m) {
  return magnitude(m);
}
template <Group G, Field S>
Base<S> size_of(Velocity<G, S> const& x) {
  return magnitude(x.coordinates);
}
template <Group G, Field S>
Base<S> size_of(Momentum<G, S> const& x) {
  return magnitude(x.components);
}
template <Group G, Field S>
Base<S> size_of(Element<G, S> const& x) {
  return magnitude(x.value);
}
template <Group G, Field S>
Element<G, S> operator-(Element<G, S> const& a, Element<G, S> const& b) {
  return {a.group, a.value - b.value};
}

/// How many random points an exact identity is tried at, for each model.
inline constexpr int exact_points = 4;
/// Numerators of random rational numbers are drawn from a set of this size (draw.hpp).
inline constexpr double draw_set = 131073.0;

/// The claims of one check over the scalar S.
template <class S>
class Claim {
 public:
  static constexpr bool exact = is_exact<S>;
  /// A residual of a well-conditioned identity stays within a few hundred roundings of the size of its terms.
  static constexpr double rounding = 300;

  Draw draw;
  Record record;

  Claim(std::string id, std::string title, std::string scalar, std::uint64_t seed) : draw(seed) {
    record.id = std::move(id), record.title = std::move(title), record.scalar = std::move(scalar), record.seed = seed;
  }

  // The verdict.

  /// Holds as printed.
  void holds(std::string note = "") { record.verdict = "holds", record.note = std::move(note); }
  /// Holds under a convention or a hypothesis, which the note names in one sentence.
  void convention(std::string note) { record.verdict = "convention", record.note = std::move(note); }
  /// Fails as printed; the corrected form (both in TeX) holds, and the printed one is a control.
  void corrected(std::string printed, std::string right, std::string note) {
    record.verdict = "corrected", record.printed = std::move(printed), record.corrected = std::move(right), record.note = std::move(note);
  }
  /// Fixes scope only, nothing to compute.
  void scope(std::string note) { record.verdict = "scope", record.note = std::move(note); }
  /// The slip may be the scan's: text recognition loses stars, inverses and signs.
  void maybe_scan() { record.scan = true; }

  // Evidence.

  /// Upper bound for the degree of the identities that follow, as polynomials in the random numbers after clearing denominators.
  void degree(int d) { degree_ = d; }

  /// The residual vanishes: exactly over the rationals, otherwise to `rounding * condition` epsilons of `scale`.
  ///
  /// @param scale      size of the terms whose cancellation is claimed
  /// @param condition  by how much the computation of the terms magnifies rounding, with a reason beside the call; 1 for plain evaluation
  template <class R, class Scale>
  void zero(std::string const& what, std::string const& model, R const& residual, Scale const& scale, double condition = 1) {
    Evidence& e = entry(what, exact ? "exact" : "precision", model);
    double const relative = relative_size(residual, scale);
    ++e.points;
    if (!(relative <= e.measured)) e.measured = relative;
    e.epsilon = to_double(epsilon<S>());
    e.bound = exact ? 0 : std::max(e.bound, rounding * condition * e.epsilon);
    if constexpr (exact) {
      if (degree_ <= 0) fail(what + " (" + model + "): an exact identity needs an upper bound for its degree");
      e.degree = degree_;
      e.probability = std::pow(degree_ / draw_set, e.points);
    }
    if (!(relative <= e.bound)) fail(what + " (" + model + "): residual " + show(relative) + " of its terms, bound " + show(e.bound));
  }
  /// Two sides are equal; the scale is that of the larger side.
  template <class L, class R>
  void equal(std::string const& what, std::string const& model, L const& left, R const& right, double condition = 1) {
    zero(what, model, difference(left, right), larger(left, right), condition);
  }

  /// Control: with a hypothesis broken the residual does not vanish. One point is enough to refute an identity, and random points are sometimes near a zero of
  /// the broken form too; so the largest residual among the points counts, and it is judged once all have been tried (`judge_controls`).
  template <class R, class Scale>
  void refutes(std::string const& what, std::string const& model, R const& residual, Scale const& scale, double floor = 1e-3) {
    double const relative = relative_size(residual, scale);
    Control& c = control_entry(what, model, relative, floor);
    ++c.points;
    if (!std::isnan(c.measured) && !(relative <= c.measured)) c.measured = relative;
  }
  /// Control: two sides differ by more than `floor` of the larger one.
  template <class L, class R>
  void differs(std::string const& what, std::string const& model, L const& left, R const& right, double floor = 1e-3) {
    refutes(what, model, difference(left, right), larger(left, right), floor);
  }

  /// The errors fall like h^expected: a line fitted to their logarithms, over at least five refinements.
  void order(std::string const& what, std::string const& model, std::vector<double> steps, std::vector<double> errors, double expected,
             double tolerance = 0.05) {
    auto const [slope, spread] = fit(steps, errors);
    Evidence& e = entry(what, "order", model);
    e.steps = std::move(steps), e.errors = std::move(errors), e.slope = slope, e.spread = spread;
    e.measured = std::abs(slope - expected), e.bound = tolerance, e.points = static_cast<int>(e.steps.size());
    if (e.steps.size() < 6) fail(what + " (" + model + "): an order needs five refinements");
    if (!(e.measured <= tolerance)) fail(what + " (" + model + "): order " + show(slope) + ", claimed " + show(expected));
  }
  /// Control: the fitted order stays below `claimed` by more than a half.
  void refutes_order(std::string const& what, std::string const& model, std::vector<double> const& steps, std::vector<double> const& errors,
                     double claimed) {
    double const shortfall = claimed - fit(steps, errors).first;
    Control& c = control_entry(what, model, shortfall, 0.5);
    c.measured = shortfall, ++c.points;
  }

  /// A fact that is no residual: true or the check fails. For controls that are refusals, say so with `refuses`.
  void fact(std::string const& what, std::string const& model, bool truth) {
    Evidence& e = entry(what, exact ? "exact" : "precision", model);
    ++e.points;
    e.degree = 0;
    if (!truth) e.measured = 1, fail(what + " (" + model + "): not so");
  }
  /// Control: the call throws `E`, which it does not with the hypothesis kept.
  template <class E, class Call>
  void refuses(std::string const& what, std::string const& model, Call const& call) {
    Control& c = control_entry(what, model, 0, 0.5);
    ++c.points;
    try {
      call();
      fail("control '" + what + "' (" + model + "): nothing was refused");
    } catch (E const&) {
      c.measured = 1;
    }
  }
  /// A control that stays at or under its floor says that the check cannot fail there: that is a failure. A NaN is one as well.
  void judge_controls() {
    for (Control const& c : record.control)
      if (!(c.measured > c.floor)) fail("control '" + c.what + "' (" + c.model + "): " + show(c.measured) + " passes, floor " + show(c.floor));
  }
  void fail(std::string message) { record.failures.push_back(std::move(message)); }

 private:
  int degree_ = 0;

  Evidence& entry(std::string const& what, std::string const& kind, std::string const& model) {
    for (Evidence& e : record.evidence)
      if (e.what == what && e.model == model && e.kind == kind) return e;
    return record.evidence.emplace_back(Evidence{.what = what, .kind = kind, .scalar = record.scalar, .model = model, .steps = {}, .errors = {}});
  }
  Control& control_entry(std::string const& what, std::string const& model, double measured, double floor) {
    for (Control& c : record.control)
      if (c.what == what && c.model == model) return c;
    return record.control.emplace_back(Control{.what = what, .scalar = record.scalar, .model = model, .measured = measured, .floor = floor});
  }

  template <class L, class R>
  static auto difference(L const& left, R const& right) {
    if constexpr (Field<L>)
      return S(left - right);
    else if constexpr (requires { left.eval(); })
      return (left - right).eval();
    else
      return left - right;
  }
  template <class L, class R>
  static Base<S> larger(L const& left, R const& right) {
    Base<S> const a = size_of(left), b = size_of(right);
    return a < b ? b : a;
  }
  template <class R, class Scale>
  static double relative_size(R const& residual, Scale const& scale) {
    Base<S> const r = size_of(residual), s = size_of(S(scale));
    if (!is_finite(r) || !is_finite(s)) return std::nan("");
    if (r == Base<S>(0)) return 0;
    if (s == Base<S>(0)) return HUGE_VAL;
    return to_double(Base<S>(r / s));
  }
  static std::pair<double, double> fit(std::vector<double> const& steps, std::vector<double> const& errors) {
    // Least squares of log error against log step, and the largest distance of a local slope from the fitted one.
    double n = static_cast<double>(steps.size()), sx = 0, sy = 0, sxx = 0, sxy = 0;
    for (std::size_t i = 0; i < steps.size(); ++i) {
      double const x = std::log(steps[i]), y = std::log(errors[i]);
      sx += x, sy += y, sxx += x * x, sxy += x * y;
    }
    double const slope = (n * sxy - sx * sy) / (n * sxx - sx * sx);
    double spread = 0;
    for (std::size_t i = 1; i < steps.size(); ++i)
      spread = std::max(spread, std::abs(std::log(errors[i] / errors[i - 1]) / std::log(steps[i] / steps[i - 1]) - slope));
    return {slope, spread};
  }
};

}  // namespace actio::checks
