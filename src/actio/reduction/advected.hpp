// Discrete Euler-Poincare equations with an advected vector: the symmetry is broken by a vector that the
// motion transports.
//
// The Lagrangian of a heavy top is not invariant under all rotations: the vertical is fixed in space. Let G
// act linearly, and let the Lagrangian on G x G depend on a vector c that is fixed in space. The symmetry
// group is the subgroup that fixes c (the case that remark 3.1.3 sets aside). The whole of G reduces all the
// same once the vector is an advected variable of the reduced system. Left-invariant, with f = g1^-1 g0 and a
// = g^-1 c, and right-invariant, with f = g0 g1^-1 and a = g c:
//
//     L(g0, g1) = l(g1^-1 g0, g0^-1 c),   a1 = f a0          L(g0, g1) = l(g0 g1^-1, g0 c),   a1 = f^-1 a0.
//
// l(f, a) is a callable at every scalar, given the vector before the step. The pair of momentum and vector
// moves on a coadjoint orbit of the semidirect product of G with the covectors. Momenta are physical, as
// everywhere: the momentum at the end of a step is that at the start of the next.
#pragma once

#include "actio/groups/solve.hpp"
#include "actio/reduction/relative_motion.hpp"

namespace actio {

/// A linear action of G on columns of numbers: act(g, a), at the scalar S.
///
/// Laws: act(gh, a) = act(g, act(h, a)), act(e, a) = a, linear in a.
template <class A, class G, class S, int m>
concept ActsOn = Group<G> && requires(A const& act, Element<G, S> const& g, Matrix<S, m, 1> const& a) {
  { act(g, a) } -> std::convertible_to<Matrix<S, m, 1>>;
};

/// How a group of m by m matrices acts on columns of m numbers: by multiplication.
struct MatrixAction {
  /// The product of the matrix and the column.
  /// @throws OutsideDomain  where the column has not as many numbers as the matrix has columns
  template <MatrixGroup G, Scalar S, int m>
  Matrix<S, m, 1> operator()(Element<G, S> const& g, Matrix<S, m, 1> const& a) const {
    if (a.size() != g.value.cols())
      throw OutsideDomain("MatrixAction",
                          "a vector with a number for each column of the matrix is needed; numbers",
                          static_cast<double>(a.size()), static_cast<double>(g.value.cols()));
    return g.value * a;
  }
};

/// What a system with an advected vector is stepped in: an element of the dual of the algebra of the
/// semidirect product.
template <Group G, Scalar S, int m>
struct AdvectedState {
  /// of the body for a left-invariant system, in space for a right-invariant one; energy x time
  Momentum<G, S> momentum;
  /// \f$g^{-1}c\f$ for a left-invariant system, \f$g\,c\f$ for a right-invariant one
  Matrix<S, m, 1> vector;
};

namespace detail {
/// l with its vector held fixed: a function of the relative motion, or of the velocity, alone.
template <class F, class S, int m>
auto holding(F const& l, Matrix<S, m, 1> const& a) {
  return [&l, a](auto const& f) {
    using T = typename std::decay_t<decltype(f)>::Scalar;
    return l(f, Matrix<T, m, 1>(a.template cast<T>()));
  };
}
}  // namespace detail

/// \f$a_1 = f\,a_0\f$: the vector after a left-invariant step with relative motion \f$f = g_1^{-1}g_0\f$.
template <Group G, Scalar S, int m, class Act = MatrixAction>
  requires ActsOn<Act, G, S, m>
Matrix<S, m, 1> advect_left(Element<G, S> const& f, Matrix<S, m, 1> const& a, Act const& act = {}) {
  return act(f, a);
}
/// \f$a_1 = f^{-1}a_0\f$: the vector after a right-invariant step with relative motion \f$f = g_0g_1^{-1}\f$.
template <Group G, Scalar S, int m, class Act = MatrixAction>
  requires ActsOn<Act, G, S, m>
Matrix<S, m, 1> advect_right(Element<G, S> const& f, Matrix<S, m, 1> const& a, Act const& act = {}) {
  return act(inverse(f), a);
}

/// \f$A_a^*\,\partial_a\ell(f, a)\f$: the differential of l in its vector, read on
/// \f$\vartheta\mapsto\frac{d}{d\epsilon}\ell(f, e^{\epsilon\vartheta}a)\f$.
///
/// @param l    reduced discrete Lagrangian with an advected vector, energy x time
/// @param a    the vector, at the scalar of f or at one below it
/// @param act  the action of G on vectors; multiplication by the matrix unless given
/// @return     covector at the identity; exact up to rounding
/// @throws NotFinite  where l or its derivative is no number
template <Group G, Scalar S, Scalar R, int m, class F, class Act = MatrixAction>
  requires ActsOn<Act, G, S, m>
Momentum<G, S> advected_differential(F const& l, Element<G, S> const& f, Matrix<R, m, 1> const& a,
                                     Act const& act = {}) {
  auto const moved_vector = [&]<class T>(Element<G, T> const& g) {
    return l(like(g, f), act(g, Matrix<T, m, 1>(a.template cast<T>())));
  };
  return right_differential(moved_vector, identity<S>(f.group));
}

// The momenta at both ends of a step.

/// \f$\Pi_0 = A_a^*\,\partial_a\ell - L_f^*\ell'\f$ at \f$(f, a_0)\f$: the body momentum with which a
/// left-invariant step begins.
template <Group G, Scalar S, Scalar R, int m, class F, class Act = MatrixAction>
Momentum<G, S> advected_momentum_before_left(F const& l, Element<G, S> const& f, Matrix<R, m, 1> const& a,
                                             Act const& act = {}) {
  return advected_differential(l, f, a, act) - left_differential(detail::holding(l, a), f);
}
/// \f$\Pi_1 = -R_f^*\ell'(f, a_0)\f$: the body momentum with which it ends.
template <Group G, Scalar S, int m, class F>
Momentum<G, S> advected_momentum_after_left(F const& l, Element<G, S> const& f, Matrix<S, m, 1> const& a) {
  return -right_differential(detail::holding(l, a), f);
}
/// \f$\mu_0 = -R_f^*\ell' - A_a^*\,\partial_a\ell\f$ at \f$(f, a_0)\f$: the spatial momentum with which a
/// right-invariant step begins.
template <Group G, Scalar S, Scalar R, int m, class F, class Act = MatrixAction>
Momentum<G, S> advected_momentum_before_right(F const& l, Element<G, S> const& f, Matrix<R, m, 1> const& a,
                                              Act const& act = {}) {
  return -right_differential(detail::holding(l, a), f) - advected_differential(l, f, a, act);
}
/// \f$\mu_1 = -L_f^*\ell'(f, a_0)\f$: the spatial momentum with which it ends.
template <Group G, Scalar S, int m, class F>
Momentum<G, S> advected_momentum_after_right(F const& l, Element<G, S> const& f, Matrix<S, m, 1> const& a) {
  return -left_differential(detail::holding(l, a), f);
}

// The equations.

/// \f$f\mapsto\Pi - \Pi_0(f, a)\f$: the equation of the left-invariant step that starts with body momentum
/// \f$\Pi\f$ and vector a; \ref momentum_equation_left with an advected vector.
/// @param l  (f, a) -> energy x time, a the vector before the step; outlives what is returned
template <Group G, Scalar S, int m, class F, class Act = MatrixAction>
auto advected_momentum_equation_left(F const& l, Momentum<G, S> const& pi, Matrix<S, m, 1> const& a,
                                     Act const& act = {}) {
  return
      [&l, pi, a, act](auto const& f) { return like(f, pi) - advected_momentum_before_left(l, f, a, act); };
}
/// \f$f\mapsto\mu - \mu_0(f, a)\f$: the same, right-invariant.
template <Group G, Scalar S, int m, class F, class Act = MatrixAction>
auto advected_momentum_equation_right(F const& l, Momentum<G, S> const& mu, Matrix<S, m, 1> const& a,
                                      Act const& act = {}) {
  return
      [&l, mu, a, act](auto const& f) { return like(f, mu) - advected_momentum_before_right(l, f, a, act); };
}

/// The discrete Euler-Poincare equations with an advected vector, left-invariant: zero along motions, and
/// only there.
///
/// \f[ L^*_{f_{21}}\ell'(f_{21}, a_1) - A_{a_1}^*\,\partial_a\ell(f_{21}, a_1) - R^*_{f_{10}}\ell'(f_{10},
///   a_0), \qquad a_1 = f_{10}\,a_0 \f]
/// It is \f$\mathrm{Ad}^*_{g_1}\f$ of the residual of the discrete Euler-Lagrange equations of
/// \ref lift_advected_left at \f$(g_0, g_1, g_2)\f$.
///
/// \implements{rem_3_1_3}
/// @param l    reduced discrete Lagrangian (f, a) -> energy x time, a the vector before the step
/// @param f10  relative motion \f$g_1^{-1}g_0\f$ over the step before
/// @param a0   the vector at \f$g_0\f$, \f$g_0^{-1}c\f$
/// @param f21  relative motion \f$g_2^{-1}g_1\f$ over the step after
/// @return     covector at the identity; exact up to rounding
template <Group G, Scalar S, int m, class F, class Act = MatrixAction>
Momentum<G, S> advected_euler_poincare_left(F const& l, Element<G, S> const& f10, Matrix<S, m, 1> const& a0,
                                            Element<G, S> const& f21, Act const& act = {}) {
  auto const a1 = advect_left(f10, a0, act);
  auto const l0 = detail::holding(l, a0), l1 = detail::holding(l, a1);
  // [rem_3_1_3]
  return left_differential(l1, f21) - advected_differential(l, f21, a1, act) - right_differential(l0, f10);
  // [rem_3_1_3]
}
/// The same, right-invariant, with \f$a_1 = f_{01}^{-1}a_0\f$; that of \ref lift_advected_right.
///
/// \f[ R^*_{f_{12}}\ell'(f_{12}, a_1) + A_{a_1}^*\,\partial_a\ell(f_{12}, a_1) - L^*_{f_{01}}\ell'(f_{01},
///   a_0) \f]
template <Group G, Scalar S, int m, class F, class Act = MatrixAction>
Momentum<G, S> advected_euler_poincare_right(F const& l, Element<G, S> const& f01, Matrix<S, m, 1> const& a0,
                                             Element<G, S> const& f12, Act const& act = {}) {
  return advected_momentum_equation_right(l, advected_momentum_after_right(l, f01, a0),
                                          advect_right(f01, a0, act), act)(f12);
}

/// The relative motion with a given body momentum at the start of the step, where the vector is a: solves
/// \f$\Pi_0(f, a) = \Pi\f$ near `start`, left-invariant.
/// @throws NotConverged, Singular  where the step is too long for the momentum
/// @throws NotFinite               where momentum or vector is no number
template <ExponentialGroup G, Real S, int m, class F, class Act = MatrixAction>
Solved<Element<G, S>> advected_relative_motion_left(F const& l, Momentum<G, S> const& pi,
                                                    Matrix<S, m, 1> const& a, Element<G, S> const& start,
                                                    Act const& act = {}) {
  require_finite(a, "advected_relative_motion_left: vector");
  require_finite(pi.components, "advected_relative_motion_left: momentum");
  return solve_on_group(advected_momentum_equation_left(l, pi, a, act), start);
}
/// The same for a spatial momentum, right-invariant.
template <ExponentialGroup G, Real S, int m, class F, class Act = MatrixAction>
Solved<Element<G, S>> advected_relative_motion_right(F const& l, Momentum<G, S> const& mu,
                                                     Matrix<S, m, 1> const& a, Element<G, S> const& start,
                                                     Act const& act = {}) {
  require_finite(a, "advected_relative_motion_right: vector");
  require_finite(mu.components, "advected_relative_motion_right: momentum");
  return solve_on_group(advected_momentum_equation_right(l, mu, a, act), start);
}

/// The next relative motion, left-invariant: solves \ref advected_euler_poincare_left for `f21`; the initial
/// guess repeats the last relative motion. The next vector is given by \ref advect_left.
/// @throws NotConverged, Singular  where the step is too long for the discrete Lagrangian to be regular
template <ExponentialGroup G, Real S, int m, class F, class Act = MatrixAction>
Solved<Element<G, S>> step_advected_euler_poincare_left(F const& l, Element<G, S> const& f10,
                                                        Matrix<S, m, 1> const& a0, Act const& act = {}) {
  return advected_relative_motion_left(l, advected_momentum_after_left(l, f10, a0), advect_left(f10, a0, act),
                                       f10, act);
}
/// The next relative motion, right-invariant: solves \ref advected_euler_poincare_right for `f12`. The next
/// vector is given by \ref advect_right.
/// @throws NotConverged, Singular  where the step is too long for the discrete Lagrangian to be regular
template <ExponentialGroup G, Real S, int m, class F, class Act = MatrixAction>
Solved<Element<G, S>> step_advected_euler_poincare_right(F const& l, Element<G, S> const& f01,
                                                         Matrix<S, m, 1> const& a0, Act const& act = {}) {
  return advected_relative_motion_right(l, advected_momentum_after_right(l, f01, a0),
                                        advect_right(f01, a0, act), f01, act);
}

/// \f$\Pi_1 = \mathrm{Ad}^*_{f^{-1}}\bigl(\Pi_0 - A_a^*\,\partial_a\ell(f, a_0)\bigr)\f$: the body momentum
/// after the step, left-invariant. Without a vector it is (3.18).
///
/// Together with \f$a_1 = f\,a_0\f$ this is the coadjoint action \f$\mathrm{Ad}^*_{k^{-1}}\f$ of
/// \f$k = f\cdot(1, \partial_a\ell)\f$, a translation by a covector followed by a rotation, in the semidirect
/// product of G with the covectors. Its Casimirs are conserved: for \f$SE(3) = SO(3)\ltimes\mathbb R^3\f$
/// they are \f$|a|^2\f$ and \f$\langle\Pi, a\rangle\f$.
/// @param f  the relative motion of the step that starts with \f$\Pi_0\f$
template <Group G, Scalar S, int m, class F, class Act = MatrixAction>
Momentum<G, S> advected_lie_poisson_update_left(F const& l, Element<G, S> const& f, Matrix<S, m, 1> const& a,
                                                Momentum<G, S> const& pi, Act const& act = {}) {
  // [advected_lie_poisson]
  return Ad_star(inverse(f), pi - advected_differential(l, f, a, act));
  // [advected_lie_poisson]
}
/// \f$\mu_1 = \mathrm{Ad}^*_f\bigl(\mu_0 + A_a^*\,\partial_a\ell(f, a_0)\bigr)\f$: the spatial momentum after
/// the step, right-invariant. Without a vector it is (3.17).
template <Group G, Scalar S, int m, class F, class Act = MatrixAction>
Momentum<G, S> advected_lie_poisson_update_right(F const& l, Element<G, S> const& f, Matrix<S, m, 1> const& a,
                                                 Momentum<G, S> const& mu, Act const& act = {}) {
  return Ad_star(f, mu + advected_differential(l, f, a, act));
}

// With and without reduction.

/// The discrete Lagrangian on G x G that l(f, a) stands for, left-invariant:
/// \f$(g_0, g_1)\mapsto\ell(g_1^{-1}g_0,\, g_0^{-1}c)\f$.
/// @param c  the vector that is fixed in space
template <class F, class S, int m, class Act = MatrixAction>
auto lift_advected_left(F l, Matrix<S, m, 1> const& c, Act act = {}) {
  return [l, c, act]<class G, class T>(Element<G, T> const& g0, Element<G, T> const& g1) {
    return l(relative_motion_left(g0, g1), act(inverse(g0), Matrix<T, m, 1>(c.template cast<T>())));
  };
}
/// The same, right-invariant: \f$(g_0, g_1)\mapsto\ell(g_0g_1^{-1},\, g_0c)\f$.
template <class F, class S, int m, class Act = MatrixAction>
auto lift_advected_right(F l, Matrix<S, m, 1> const& c, Act act = {}) {
  return [l, c, act]<class G, class T>(Element<G, T> const& g0, Element<G, T> const& g1) {
    return l(relative_motion_right(g0, g1), act(g0, Matrix<T, m, 1>(c.template cast<T>())));
  };
}

}  // namespace actio
