// The implicit algorithm on the algebra (thesis, section 3.3): relative motions by their logarithms.
//
// With xi = log f the velocity of a step is -xi/h, and the discrete Euler-Poincare equations of the natural
// chart become equations between vectors of the algebra.
#pragma once

#include "actio/groups/solve.hpp"
#include "actio/groups/unipotent_groups.hpp"
#include "actio/linear_algebra/iex.hpp"
#include "actio/reduction/natural_chart.hpp"

namespace actio {

/// \f$\mu\cdot A\f$: a covector composed with a linear map of the algebra.
template <Group G, Scalar S, MatrixLike M>
Momentum<G, S> composed(Momentum<G, S> const& mu, M const& a) {
  return {mu.group, a.transpose() * mu.components};
}

/// \f$l'(-\xi/h)\cdot\chi(\pm\mathrm{ad}_\xi)\f$ as covectors: the momenta at the two ends of a step with
/// relative motion \f$e^\xi\f$. \f$\chi(\mathrm{ad}_\xi)\f$ is the differential of log read on
/// \f$e^{\vartheta}f\f$, \f$\chi(-\mathrm{ad}_\xi) = \chi(\mathrm{ad}_\xi)\,e^{\mathrm{ad}_\xi}\f$ read on
/// \f$f\,e^\vartheta\f$.
/// @param l  reduced Lagrangian, energy
/// @param h  step, time; not zero, negative to go back
template <Group G, Scalar S, class F, class T>
Momentum<G, S> momentum_through_log_right(F const& l, T const& h, Velocity<G, S> const& xi) {
  return composed(gradient(l, -xi / detail::constant<S>(h)), chi(ad_matrix(xi)));
}
/// \copydoc momentum_through_log_right
template <Group G, Scalar S, class F, class T>
Momentum<G, S> momentum_through_log_left(F const& l, T const& h, Velocity<G, S> const& xi) {
  return composed(gradient(l, -xi / detail::constant<S>(h)), chi(ad_matrix(-xi)));
}

/// The residual of the implicit algorithm on the algebra, right-invariant: zero along the logarithms of the
/// motions of \ref euler_poincare_right, and only there.
///
/// \f[ l'(-\xi_{12}/h)\cdot\chi(\mathrm{ad}_{\xi_{12}}) \;-\;
///   l'(-\xi_{01}/h)\cdot\chi(\mathrm{ad}_{\xi_{01}})\cdot\exp(\mathrm{ad}_{\xi_{01}}), \qquad
///   \chi\cdot\mathrm{iex} = 1 \f]
/// The momentum at the start of the step after, less that at the end of the step before: minus the residual
/// (3.10) of \ref natural_chart_lagrangian_right.
///
/// \implements{eq_3_26}
/// @param l     reduced Lagrangian, function of \f$\dot g g^{-1}\f$, energy
/// @param h     step, time; not zero, negative to go back
/// @param xi01  logarithm of \f$f_{01} = g_0g_1^{-1}\f$
/// @param xi12  logarithm of \f$f_{12} = g_1g_2^{-1}\f$
/// Exact up to rounding.
template <Group G, Scalar S, class F, class T>
Momentum<G, S> algebra_euler_poincare_right(F const& l, T const& h, Velocity<G, S> const& xi01,
                                            Velocity<G, S> const& xi12) {
  detail::nonzero_step(h);
  auto const slope01 = gradient(l, -xi01 / detail::constant<S>(h)),
             slope12 = gradient(l, -xi12 / detail::constant<S>(h));
  auto const ad01 = ad_matrix(xi01), ad12 = ad_matrix(xi12);
  // [eq_3_26]
  return composed(slope12, chi(ad12)) - composed(slope01, chi(ad01) * matrix_exponential(ad01));
  // [eq_3_26]
}
/// The residual of the implicit algorithm on the algebra, left-invariant: minus the residual (3.11) of
/// \ref natural_chart_lagrangian_left.
///
/// @param xi10  logarithm of \f$f_{10} = g_1^{-1}g_0\f$
/// @param xi21  logarithm of \f$f_{21} = g_2^{-1}g_1\f$
template <Group G, Scalar S, class F, class T>
Momentum<G, S> algebra_euler_poincare_left(F const& l, T const& h, Velocity<G, S> const& xi10,
                                           Velocity<G, S> const& xi21) {
  detail::nonzero_step(h);
  return momentum_through_log_left(l, h, xi21) - momentum_through_log_right(l, h, xi10);
}

namespace detail {
/// Solves residual(xi) = 0 in the algebra, by Newton's iteration on the group that it is under addition.
template <Group G, Real S, class Residual>
Solved<Velocity<G, S>> solve_in_algebra(Residual const& residual, Velocity<G, S> const& start) {
  Translations<G::dim> additive{};
  if constexpr (G::dim == Dynamic) additive = {start.group.dimension()};
  auto solved = solve_on_group(
      [&]<class A, class R>(Element<A, R> const& x) {
        return residual(Velocity<G, R>{start.group, x.value});
      },
      Element<Translations<G::dim>, S>{additive, start.coordinates});
  return {{start.group, solved.value.value}, std::move(solved.report)};
}
}  // namespace detail

/// The next logarithm of a right-invariant system: solves \ref algebra_euler_poincare_right for `xi12`; the
/// initial guess repeats the last relative motion.
/// @throws NotConverged, Singular where the step is too long for the discrete Lagrangian to be regular, or
///         for \f$\chi\f$
template <ExponentialGroup G, Real S, class F, class T>
Solved<Velocity<G, S>> step_algebra_euler_poincare_right(F const& l, T const& h, Velocity<G, S> const& xi01) {
  detail::nonzero_step(h);
  auto const end_momentum = momentum_through_log_left(l, h, xi01);
  return detail::solve_in_algebra(
      [&](auto const& xi) { return momentum_through_log_right(l, h, xi) - like(xi, end_momentum); }, xi01);
}
/// The next logarithm of a left-invariant system: solves \ref algebra_euler_poincare_left for `xi21`.
/// Otherwise as \ref step_algebra_euler_poincare_right.
template <ExponentialGroup G, Real S, class F, class T>
Solved<Velocity<G, S>> step_algebra_euler_poincare_left(F const& l, T const& h, Velocity<G, S> const& xi10) {
  detail::nonzero_step(h);
  auto const end_momentum = momentum_through_log_right(l, h, xi10);
  return detail::solve_in_algebra(
      [&](auto const& xi) { return momentum_through_log_left(l, h, xi) - like(xi, end_momentum); }, xi10);
}

}  // namespace actio
