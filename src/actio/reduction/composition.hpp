// Compositions: several steps, some of them backwards, that make one step of higher order.
//
// The base step must be self-adjoint: a step by -h undoes one by h. Then its error has even powers of h only,
// and substeps gamma_1 h, ..., gamma_n h in a palindromic pattern cancel them one after another. Each substep
// is a step of the discrete Lie-Poisson algorithm, so the composition preserves what each preserves: the
// coadjoint orbit, the bracket, the momentum of the symmetry.
#pragma once

#include <vector>

#include "actio/reduction/momentum_step.hpp"

namespace actio {

/// The residual of the conditions for order 6 on the fractions of a symmetric composition of a self-adjoint
/// step of order 2; the first two are those for order 4.
///
/// \f[ \sum_k\gamma_k - 1,\qquad \sum_k\gamma_k^3,\qquad \sum_k\gamma_k^5,\qquad \sum_k\gamma_k^3\,m_k^2,
///    \qquad m_k = \gamma_1+\dots+\gamma_{k-1}+\tfrac12\gamma_k \f]
/// The step is \f$\exp(hA_1 + h^3A_3 + h^5A_5 + \dots)\f$. In the product of its substeps \f$A_3\f$ and
/// \f$A_5\f$ occur with the sums of cubes and of fifth powers, and \f$[A_1,[A_1,A_3]]\f$ with the cubes
/// weighted by the square of the time \f$m_k\f$ in the middle of the substep. Exact up to rounding.
template <Scalar S>
Matrix<S, 4, 1> composition_conditions(std::vector<S> const& gamma) {
  Matrix<S, 4, 1> left(S(-1), S(0), S(0), S(0));
  S reached(0);
  for (S const& g : gamma) {
    // [composition_conditions]
    S const cube = g * g * g, m = reached + g / S(2);
    left += Matrix<S, 4, 1>(g, cube, cube * g * g, cube * m * m);
    // [composition_conditions]
    reached += g;
  }
  return left;
}

/// Order 4 in three stages: \f$\gamma_1 = \gamma_3 = 1/(2-\sqrt[3]2)\f$, and back by
/// \f$\gamma_2 = 1 - 2\gamma_1\f$. Few stages, large error.
template <Real S>
std::vector<S> triple_jump() {
  using std::exp, std::log;
  S const outer = S(1) / (S(2) - S(exp(S(log(S(2)) / S(3)))));
  return {outer, S(1) - outer - outer, outer};
}
/// Order 2, 4, 6 or 8 by Suzuki's fractals, in 1, 5, 25 or 125 stages: \f$s, s, 1-4s, s, s\f$ with
/// \f$s = 1/(4-4^{1/(p+1)})\f$ takes order p to p + 2. Steps back in time are shorter than those of the
/// triple jump.
/// @param order  2, 4, 6 or 8
/// @throws OutsideDomain  for another
template <Real S>
std::vector<S> symmetric_composition(int order) {
  if (order < 2 || order > 8 || order % 2)
    throw OutsideDomain("symmetric composition", "the order must be 2, 4, 6 or 8", order, order < 2 ? 2 : 8);
  using std::pow;
  std::vector<S> fractions{S(1)};
  for (int p = 2; p < order; p += 2) {
    S const outer = S(1) / (S(4) - S(pow(S(4), S(S(1) / S(p + 1))))), inner = S(1) - S(4) * outer;
    std::vector<S> composed;
    for (S const& s : {outer, outer, inner, outer, outer})
      for (S const& f : fractions) composed.push_back(s * f);
    fractions = std::move(composed);
  }
  return fractions;
}
/// Order 4 in five stages (Suzuki): \f$\gamma_1 = \gamma_2 = \gamma_4 = \gamma_5 = 1/(4-\sqrt[3]4)\f$ and
/// \f$\gamma_3 = 1 - 4\gamma_1\f$. No substep is longer than 0.66 of the step.
///
/// \snippet reduction.cpp composed_left
template <Real S>
std::vector<S> suzuki() { return symmetric_composition<S>(4); }
/// Order 6 in nine stages (Kahan and Li): \f$\gamma_1, \dots, \gamma_5\f$ and back.
///
/// Five numbers for four conditions leave one free. The first is that of Kahan and Li, to the 26 digits they
/// print; the others solve \ref composition_conditions by Newton's iteration, in as many digits as the scalar
/// has.
template <Real S>
  requires Plain<S>
std::vector<S> kahan_li() {
  S const shift(10000000000000L);  // 10^13
  S const first = (S(3921614440073L) + S(1413927925056L) / shift) / shift;
  Matrix<S, 4, 1> rest(S(0.332599136789359), S(-0.706246172557639), S(0.082213596293550),
                       S(0.798543990934829));
  auto const there_and_back = [&first]<class T>(Matrix<T, 4, 1> const& g) {
    return std::vector<T>{T(first), g[0], g[1], g[2], g[3], g[2], g[1], g[0], T(first)};
  };
  for (double digits = 10; digits < 3 * decimal_digits<S>(); digits *= 2) {
    auto const [value, slope] =
        derivative([&](auto const& g) { return composition_conditions(there_and_back(g)); }, rest);
    rest -= solve_linear(slope, value, "kahan_li");
  }
  return there_and_back(rest);
}

namespace detail {
/// Fractions that make up a whole step.
template <class S>
std::vector<S> fractions_of_a_step(std::vector<S> fractions) {
  S sum(0), size(0);
  for (S const& f : fractions) {
    if (!is_finite(f)) throw NotFinite("composition: fraction of a step");
    sum += f, size += magnitude(f);
  }
  if (!(magnitude(S(sum - S(1))) <= S(8) * epsilon<S>() * (S(1) + size)))
    throw OutsideDomain("composition", "the fractions of a step must add up to 1", to_double(sum), 1);
  return fractions;
}
}  // namespace detail

/// Substeps \f$\gamma_1h, \dots, \gamma_nh\f$ of a step as one step.
/// @tparam Invariance  \ref RightInvariant or \ref LeftInvariant
template <class Invariance, class Step, class S>
struct Composed {
  std::vector<S> fractions;  ///< of the step; they add up to 1
  std::vector<Step> steps;   ///< (state, h) -> `MomentumStep`, one for each fraction, since a step may
                             ///< remember the last one of its length

  /// @throws OutsideDomain, NotFinite  where the fractions do not add up to 1, or are no numbers
  Composed(Step step_of, std::vector<S> fractions_of)
      : fractions(detail::fractions_of_a_step(std::move(fractions_of))), steps(fractions.size(), step_of) {}

  /// A step of length h from a state.
  template <Group G, Scalar T>
  MomentumStep<G, T> operator()(MomentumState<G, T> const& from, std::type_identity_t<S> const& h) const {
    auto whole = steps[0](from, S(fractions[0] * h));
    for (std::size_t k = 1; k < fractions.size(); ++k) {
      auto next = steps[k](whole.state, S(fractions[k] * h));
      whole = {Invariance::joined(whole.relative_motion, next.relative_motion), std::move(next.state),
               whole.evaluations + next.evaluations};
    }
    return whole;
  }
};
/// Substeps of a right-invariant step as one step, with relative motion \f$f_1f_2\cdots f_n\f$.
template <class Step, class S>
struct ComposedRight : Composed<RightInvariant, Step, S> {
  /// @throws OutsideDomain, NotFinite  where the fractions do not add up to 1, or are no numbers
  ComposedRight(Step step, std::vector<S> const& parts) : ComposedRight::Composed(std::move(step), parts) {}
};
/// Substeps of a left-invariant step as one step, with relative motion \f$f_n\cdots f_2f_1\f$.
///
/// \snippet reduction.cpp composed_left
template <class Step, class S>
struct ComposedLeft : Composed<LeftInvariant, Step, S> {
  /// @throws OutsideDomain, NotFinite  where the fractions do not add up to 1, or are no numbers
  ComposedLeft(Step step, std::vector<S> const& parts) : ComposedLeft::Composed(std::move(step), parts) {}
};

}  // namespace actio
