// What a check claims about a statement of the thesis, and what was measured.
//
// A check calls `zero` or `equal` for what must vanish, `order` for a rate, and `refutes` or `differs` for
// the control: the same quantity with one hypothesis broken, one sign or one index flipped, which must not
// vanish. Everything that is measured goes to the ledger.
#pragma once

#include <cmath>
#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "actio/numbers/square_root.hpp"
#include "witness/draw.hpp"
#include "witness/number.hpp"
#include "witness/number_counts.hpp"

namespace actio::checks {

/// Whether numbers grow longer with every operation: over the rationals, where a check takes smaller models.
inline bool numbers_grow() { return current_arithmetic().kind() == ArithmeticKind::rational; }

/// A number is positive: over a field without order a square stands for that, and the draw is made again
/// where x is none. Roots have then the signs that formulas with positive numbers give them.
template <class S>
void draw_positive(S const& x) {
  if (!ordered_arithmetic<S>()) square_root(base_value(x));
}
/// |x|: over a field without order whichever of x and -x is a square.
template <class S>
S modulus(S const& x) { return ordered_arithmetic<S>() ? (x < S(0) ? S(-x) : x) : square_root(S(x * x)); }

/// One measured figure that speaks for a statement.
struct Evidence {
  std::string what, kind, scalar, model;
  double measured = 0, bound = 0, epsilon = 0;
  std::vector<double> steps, errors;
  double slope = 0, spread = 0;
  double degree = 0;
  int points = 0;  ///< where it was tried; of an enclosure the boxes
  double probability = 0;
  double margin = 0;  ///< of an enclosure: how far what is claimed to be positive is above zero, rounded
};
/// The same quantity with a hypothesis broken: it must stay above the floor.
struct Control {
  std::string what, scalar, model;
  double measured = 0, floor = 0;
  double median = 0;  ///< of all draws; `measured` is the largest
  int points = 0;
  std::vector<double> draws;  ///< each of them, for the median
};
/// What was decided about a whole set: for every point of a path or a box, not at samples.
struct Enclosure {
  bool shown = false;    ///< whether it was decided that the claim is true on all of the set
  double margin = 0;     ///< by how much at least: a lower bound of what is claimed to be positive
  int boxes = 0;         ///< into how many pieces the set was divided
  bool refuted = false;  ///< whether it was decided that the claim is false somewhere in the set
};
/// All that one run of a check, over one scalar, says about its statement.
struct Record {
  std::string id, title, scalar, verdict, printed, corrected, note, source;
  std::string left;   ///< what of the statement no line of the check speaks to; empty where nothing is left
  std::string first;  ///< the statement where the slip that this one carries occurs first
  bool scan = false;
  std::vector<Evidence> evidence;
  std::vector<Control> control;
  std::vector<std::string> failures;
  std::uint64_t seed = 0;
  int redrawn = 0;  ///< draws at which a divisor vanished or a root was missing, and which were drawn again
  double seconds = 0;
};

/// Numbers a quantity is made of: a scalar, a matrix, a velocity, a momentum, an element.
template <Scalar S>
Base<S> size_of(S const& x) { return magnitude(x); }
template <MatrixLike M>
auto size_of(M const& m) { return magnitude(m); }
template <Group G, Scalar S>
Base<S> size_of(Velocity<G, S> const& x) { return magnitude(x.coordinates); }
template <Group G, Scalar S>
Base<S> size_of(Momentum<G, S> const& x) { return magnitude(x.components); }
template <Group G, Scalar S>
Base<S> size_of(Element<G, S> const& x) { return magnitude(x.value); }
template <Group G, Scalar S>
Element<G, S> operator-(Element<G, S> const& a, Element<G, S> const& b) {
  return {a.group, a.value - b.value};
}

/// The part of a claim that does not depend on its scalar: records and judgements, compiled once (claim.cpp).
/// Texts come as views, which cost a caller nothing.
class AnyClaim {
 public:
  /// A residual of a well-conditioned identity stays within a few hundred roundings of the size of its terms.
  static constexpr double rounding = 300;
  /// With more digits than these the spacing of numbers is written as \ref least_epsilon, which a double can
  /// hold.
  static constexpr int most_digits_of_double = 290;
  static constexpr double least_epsilon = 1e-290;

  Draw draw;
  Record record;

  /// @param epsilon  of the scalar; 0 where it is exact
  AnyClaim(std::string_view id, std::string_view title, std::string_view scalar, std::uint64_t seed,
           double epsilon);

  /// Whether orders are fitted in this call: in double, once.
  bool fits_orders() const { return pass == 0 && current_arithmetic().kind() == ArithmeticKind::hardware; }
  /// Whether orders are fitted in this call that would end in the rounding of double: in fifty digits, once.
  bool fits_orders_in_digits() const {
    return pass == 0 && current_arithmetic().kind() == ArithmeticKind::decimal &&
           current_arithmetic().digits() == 50;
  }
  /// Whether this is the first call: for what draws nothing, and would say the same again.
  bool first() const { return pass == 0; }

  int pass = 0;  ///< how often the check was called before
  /// Degrees of the identities, found in a prime field, by what is claimed and the model: for the columns
  /// that cannot measure them.
  std::map<std::string, double> const* degrees = nullptr;

  // The verdict.

  /// Holds as printed.
  void holds(std::string_view note = {});
  /// Holds under a convention or a hypothesis, which the note names in one sentence.
  void convention(std::string_view note);
  /// Fails as printed; the corrected form (both in TeX) holds, and the printed one is a control.
  void corrected(std::string_view printed, std::string_view right, std::string_view note);
  /// Fixes scope only, nothing to compute.
  void scope(std::string_view note);
  /// The slip may be the scan's: text recognition drops stars, inverses and signs.
  void maybe_scan();
  /// The slip occurs first elsewhere: the verdict is the same, or a convention judged with that put right.
  void same_slip_as(std::string_view id);
  /// What of the statement is not shown here, and why: the ledger calls the check partial and prints this.
  void leaves(std::string_view sentence);

  // Evidence that is no residual.

  /// The errors fall like h^expected: a line fitted to their logarithms, over at least five refinements.
  void order(std::string_view what, std::string_view model, std::vector<double> const& steps,
             std::vector<double> const& errors, double expected, double tolerance = 0.05);
  /// Control: the fitted order stays below `claimed` by more than a half.
  void refutes_order(std::string_view what, std::string_view model, std::vector<double> const& steps,
                     std::vector<double> const& errors, double claimed);
  /// A fact that is no residual: true or the check fails. For controls that are refusals, say so with
  /// `refuses`.
  void fact(std::string_view what, std::string_view model, bool truth);
  /// Control: the call throws `E`, which it does not under the hypothesis.
  template <class E, class Call>
  void refuses(std::string_view what, std::string_view model, Call const& call) {
    try {
      call();
      refused(what, model, false);
    } catch (E const&) {
      refused(what, model, true);
    }
  }
  /// Whether claims about whole sets are decided in this call: in the column of doubles, once. The body makes
  /// its models anew over balls, inside the call that it gives to `encloses`.
  bool takes_enclosures() const { return fits_orders(); }
  /// Decided on a whole set, in balls: `call()` returns an Enclosure (enclosures.hpp). It runs with balls of
  /// 20 digits, and of more while these do not decide.
  template <class Call>
  void encloses(std::string_view what, std::string_view model, Call const& call) {
    if (takes_enclosures()) enclosed(what, model, in_balls(call), true);
  }
  /// Control: with a hypothesis broken the same question is not decided in favour of the claim. The ledger
  /// says whether it was decided against it, or not at all.
  template <class Call>
  void refutes_enclosure(std::string_view what, std::string_view model, Call const& call) {
    if (takes_enclosures()) enclosed(what, model, in_balls(call), false);
  }
  /// A control that stays at or under its floor says that the check cannot fail there: that is a failure. A
  /// NaN is one as well.
  void judge_controls();
  void fail(std::string_view message);

 protected:
  /// A residual of this relative size was claimed to vanish.
  /// @param degree  upper bound of its degree in the random numbers; 0 where it is not known
  void vanishes(std::string_view what, std::string_view model, double relative, double condition,
                double degree);
  /// Of the numbers whose size was asked for last. Each different root counts fourfold: the norm over its
  /// signs has twice the degree, and half of the points have one.
  static double degree_of_residual();
  /// A residual of this relative size was claimed not to vanish.
  void stays(std::string_view what, std::string_view model, double relative, double floor);

 private:
  double epsilon_;

  static bool exact() { return current_arithmetic().exact(); }
  template <class Call>
  static Enclosure in_balls(Call const& call) {
    for (int digits = 20; digits <= 160; digits *= 2) {
      WithArithmetic const balls(Arithmetic::balls(digits));
      try {
        if (Enclosure const found = call(); found.shown || found.refuted || digits == 160) return found;
      } catch (Undecided const&) {
      }
    }
    return {};
  }
  void enclosed(std::string_view what, std::string_view model, Enclosure const& found, bool claimed);
  void refused(std::string_view what, std::string_view model, bool truth);
  Evidence& entry(std::string_view what, std::string_view kind, std::string_view model);
  Control& control_entry(std::string_view what, std::string_view model, double measured, double floor);
};

/// The claims of one check over the scalar S.
template <class S>
class Claim : public AnyClaim {
 public:
  Claim(std::string_view id, std::string_view title, std::string_view scalar, std::uint64_t seed)
      : AnyClaim(id, title, scalar, seed, to_double(epsilon<S>())) {}

  /// The residual vanishes: exactly over an exact arithmetic, otherwise to `rounding * condition` epsilons of
  /// `scale`.
  ///
  /// @param scale      size of the terms whose cancellation is claimed
  /// @param condition  by how much the computation of the terms magnifies rounding, with a reason beside the
  ///                   call; 1 for plain evaluation
  template <class R, class Scale>
  void zero(std::string_view what, std::string_view model, R const& residual, Scale const& scale,
            double condition = 1) {
    forget_degrees();
    Base<S> const size = size_of(residual);
    double const degree = degree_of_residual();
    vanishes(what, model, in_roundings(size, size_of(S(scale))), condition, degree);
  }
  /// Two sides are equal; the scale is that of the larger side.
  template <class L, class R>
  void equal(std::string_view what, std::string_view model, L const& left, R const& right,
             double condition = 1) {
    zero(what, model, difference(left, right), larger(size_of(left), size_of(right)), condition);
  }

  /// Control: with a hypothesis broken the residual does not vanish. One point is enough to refute an
  /// identity, and random points are sometimes near a zero of the broken form too; so the largest residual
  /// among the points counts, and it is judged once all have been tried (`judge_controls`).
  template <class R, class Scale>
  void refutes(std::string_view what, std::string_view model, R const& residual, Scale const& scale,
               double floor = 1e-3) {
    stays(what, model, quotient(size_of(residual), size_of(S(scale))), floor);
  }
  /// Control: two sides differ by more than `floor` of the larger one.
  template <class L, class R>
  void differs(std::string_view what, std::string_view model, L const& left, R const& right,
               double floor = 1e-3) {
    refutes(what, model, difference(left, right), larger(size_of(left), size_of(right)), floor);
  }

 private:
  template <class L, class R>
  static auto difference(L const& left, R const& right) {
    if constexpr (Scalar<L>)
      return S(left - right);
    else if constexpr (requires { left.eval(); })
      return (left - right).eval();
    else
      return left - right;
  }
  static Base<S> larger(Base<S> const& a, Base<S> const& b) { return a < b ? b : a; }
  /// The same as quotient, for what is claimed to vanish: beyond the range of double the roundings are
  /// counted first, so that none is lost.
  static double in_roundings(Base<S> const& residual, Base<S> const& scale) {
    if (decimal_digits<S>() <= most_digits_of_double || !is_finite(residual) || !is_finite(scale) ||
        scale == Base<S>(0))
      return quotient(residual, scale);
    return to_double(Base<S>(residual / scale / epsilon<S>())) * least_epsilon;
  }
  /// Size of a residual relative to that of its terms.
  static double quotient(Base<S> const& residual, Base<S> const& scale) {
    if (!is_finite(residual) || !is_finite(scale)) return std::nan("");
    if (residual == Base<S>(0)) return 0;
    if (scale == Base<S>(0)) return HUGE_VAL;
    return to_double(Base<S>(residual / scale));
  }
};

}  // namespace actio::checks
