// Discrete Euler-Poincare equations: the discrete motion of an invariant system, in relative motions alone.
//
// A discrete Lagrangian that does not change under right multiplication is a function l of f01 = g0 g1^-1;
// one that does not change under left multiplication is a function of f10 = g1^-1 g0. Along a motion the
// momentum at the end of a step equals that at the start of the next. The two sides have their own functions;
// neither is obtained from the other by a flag.
//
// What the step after has to satisfy is the momentum equation below. The lines of (3.10) and (3.11) put the
// momentum of the step before into it, solvers any other momentum, and steppers the one that Ad* transports.
#pragma once

#include "actio/groups/solve.hpp"

namespace actio {

/// \f$f\mapsto R_f^*\ell'(f) + \mu\f$: the equation of the right-invariant step that starts with momentum
/// \f$\mu\f$. It is zero where \f$-R_f^*\ell'(f) = \mu\f$, and only there.
///
/// @param l   reduced discrete Lagrangian, \f$G\to\mathbb R\f$, energy x time; outlives what is returned
/// @param mu  spatial momentum at the start of the step
/// @return    relative motion at any scalar -> covector at the identity; exact up to rounding
template <Group G, Scalar S, class F>
auto momentum_equation_right(F const& l, Momentum<G, S> const& mu) {
  // [momentum_equation_right]
  return [&l, mu](auto const& f) { return right_differential(l, f) + like(f, mu); };
  // [momentum_equation_right]
}
/// \f$f\mapsto L_f^*\ell'(f) + \Pi\f$: the equation of the left-invariant step that starts with the body
/// momentum \f$\Pi\f$. Otherwise as \ref momentum_equation_right.
template <Group G, Scalar S, class F>
auto momentum_equation_left(F const& l, Momentum<G, S> const& pi) {
  // [momentum_equation_left]
  return [&l, pi](auto const& f) { return left_differential(l, f) + like(f, pi); };
  // [momentum_equation_left]
}

/// The discrete Euler-Poincare equations of a right-invariant system, as an equation for the step after:
/// \f$f_{12}\mapsto R^*_{f_{12}}\,\ell'(f_{12}) - L^*_{f_{01}}\,\ell'(f_{01})\f$, the momentum equation with
/// the momentum at the end of the step before.
///
/// \implements{eq_3_10}
/// @param l    reduced discrete Lagrangian, energy x time; outlives what is returned
/// @param f01  relative motion \f$g_0g_1^{-1}\f$ over the step before
template <Group G, Scalar S, class F>
auto euler_poincare_right(F const& l, Element<G, S> const& f01) {
  // [eq_3_10]
  return momentum_equation_right(l, -left_differential(l, f01));
  // [eq_3_10]
}
/// The same of a left-invariant system:
/// \f$f_{21}\mapsto L^*_{f_{21}}\,\ell'(f_{21}) - R^*_{f_{10}}\,\ell'(f_{10})\f$.
///
/// \implements{eq_3_11}
/// @param l    reduced discrete Lagrangian, energy x time; outlives what is returned
/// @param f10  relative motion \f$g_1^{-1}g_0\f$ over the step before
template <Group G, Scalar S, class F>
auto euler_poincare_left(F const& l, Element<G, S> const& f10) {
  // [eq_3_11]
  return momentum_equation_left(l, -right_differential(l, f10));
  // [eq_3_11]
}
/// The residual of the discrete Euler-Poincare equations (3.10) of a right-invariant system: zero along
/// motions, and only there.
/// @param f12  relative motion \f$g_1g_2^{-1}\f$ over the step after
/// @return     covector at the identity; exact up to rounding
template <Group G, Scalar S, class F>
Momentum<G, S> euler_poincare_right(F const& l, Element<G, S> const& f01, Element<G, S> const& f12) {
  return euler_poincare_right(l, f01)(f12);
}
/// The residual of the discrete Euler-Poincare equations (3.11) of a left-invariant system.
/// @param f21  relative motion \f$g_2^{-1}g_1\f$ over the step after
template <Group G, Scalar S, class F>
Momentum<G, S> euler_poincare_left(F const& l, Element<G, S> const& f10, Element<G, S> const& f21) {
  return euler_poincare_left(l, f10)(f21);
}

/// The next relative motion of a right-invariant system: solves (3.10), \ref euler_poincare_right, for `f12`;
/// the initial guess repeats the last relative motion.
/// @throws NotConverged, Singular  where the step is too long for the discrete Lagrangian to be regular
template <ExponentialGroup G, Real S, class F>
Solved<Element<G, S>> step_euler_poincare_right(F const& l, Element<G, S> const& f01) {
  return solve_on_group(euler_poincare_right(l, f01), f01);
}
/// The next relative motion of a left-invariant system: solves (3.11), \ref euler_poincare_left, for `f21`.
/// Otherwise as \ref step_euler_poincare_right.
///
/// \snippet reduction.cpp step_euler_poincare_left
template <ExponentialGroup G, Real S, class F>
Solved<Element<G, S>> step_euler_poincare_left(F const& l, Element<G, S> const& f10) {
  return solve_on_group(euler_poincare_left(l, f10), f10);
}

namespace detail {
/// How a covector at f changes when f moves to \f$e^\vartheta f\f$. Row: component; column: direction.
template <Group G, Scalar S, class Covector>
auto change_of(Covector const& covector, Element<G, S> const& f) {
  int const n = f.group.dimension();
  Matrix<S, G::dim, G::dim> m(n, n);
  over_batches(n, [&](int first) { store_parts(m, covector(moved_left(f, first)).components, first); });
  return m;
}
}  // namespace detail

/// How \f$R_f^*\ell'(f)\f$ changes when f moves to \f$e^\vartheta f\f$. Row: component; column: direction.
template <Group G, Scalar S, class F>
auto right_second_differential(F const& l, Element<G, S> const& f) {
  return detail::change_of([&](auto const& x) { return right_differential(l, x); }, f);
}
/// How \f$L_f^*\ell'(f)\f$ changes when f moves to \f$e^\vartheta f\f$. Row: component; column: direction.
template <Group G, Scalar S, class F>
auto left_second_differential(F const& l, Element<G, S> const& f) {
  return detail::change_of([&](auto const& x) { return left_differential(l, x); }, f);
}

/// The tangent of the right-invariant algorithm \f$f_{01}\mapsto f_{12}\f$, where the two satisfy (3.10):
/// \f$\vartheta_{01}\mapsto\vartheta_{12}\f$, each being \f$\delta f\,f^{-1}\f$. From the equation, not from
/// the solver: exact at every scalar.
/// @throws Singular  where l is not regular at f12
template <Group G, Scalar S, class F>
auto euler_poincare_tangent_right(F const& l, Element<G, S> const& f01, Element<G, S> const& f12) {
  return solve_linear(right_second_differential(l, f12), left_second_differential(l, f01),
                      "discrete Euler-Poincare: l''");
}
/// The tangent of the left-invariant algorithm \f$f_{10}\mapsto f_{21}\f$, where the two satisfy (3.11).
/// @throws Singular  where l is not regular at f21
template <Group G, Scalar S, class F>
auto euler_poincare_tangent_left(F const& l, Element<G, S> const& f10, Element<G, S> const& f21) {
  return solve_linear(left_second_differential(l, f21), right_second_differential(l, f10),
                      "discrete Euler-Poincare: l''");
}

}  // namespace actio
