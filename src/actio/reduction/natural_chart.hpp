// Discretization by natural charts: a continuous Lagrangian becomes a discrete one through the exponential
// map (thesis, section 3.3).
//
// The chart at g is psi_g(k) = log(k g^-1) for right translation, phi_g(k) = log(g^-1 k) for left
// translation. Two configurations are averaged and subtracted in it. A discrete Lagrangian is an action: the
// step times the Lagrangian.
//
// phi_g = Ad(g^-1) psi_g, so both charts at one g make the same discrete Lagrangian of the same L; each has
// its function because each reads off its own velocity. A discrete Lagrangian inherits an invariance of L
// where the base point is equivariant: base(g1 k, g2 k) = base(g1, g2) k, or the same on the left.
#pragma once

#include "actio/groups/group.hpp"
#include "actio/linear_algebra/iex.hpp"
#include "actio/reduction/relative_motion.hpp"
#include "actio/variational/state.hpp"

namespace actio {

namespace detail {
/// A step that can be divided by, forwards or backwards: the action of a negative step is
/// \f$h\,l(-\log(f)/h)\f$ as well.
template <class T>
T const& nonzero_step(T const& h) {
  if (base_value(h) == Base<T>(0) || !is_finite(Base<T>(base_value(h))))
    throw OutsideDomain("natural chart", "a step must be finite and not zero (3.20)", to_double(h), 0);
  return h;
}
/// The step as a constant of the scalar S.
template <class S, class T>
S constant(T const& h) { return S(Base<S>(h)); }
}  // namespace detail

/// \f$\psi_g(k) = \log(k\,g^{-1})\f$, the natural chart at g by right translation.
///
/// \implements{eq_3_19}
/// @throws OutsideDomain  where k is outside the chart
template <ExponentialGroup G, Scalar S>
Velocity<G, S> natural_chart_right(Element<G, S> const& g, Element<G, S> const& k) {
  // [eq_3_19]
  return log(k * inverse(g));
  // [eq_3_19]
}
/// \f$\phi_g(k) = \log(g^{-1}k)\f$, the natural chart at g by left translation.
/// @throws OutsideDomain  where k is outside the chart
template <ExponentialGroup G, Scalar S>
Velocity<G, S> natural_chart_left(Element<G, S> const& g, Element<G, S> const& k) {
  return log(inverse(g) * k);
}

/// Average and difference of two configurations in a chart.
template <Group G, Scalar S>
struct ChartMidpoint {
  Velocity<G, S> eta;   ///< \f$\eta\f$, the average
  Velocity<G, S> zeta;  ///< \f$\zeta\f$, the difference over the step, 1/time
};
/// \f$\eta = \tfrac12(\psi_g(g_1)+\psi_g(g_2))\f$ and \f$\zeta = \tfrac1h(\psi_g(g_2)-\psi_g(g_1))\f$ in the
/// chart at g by right translation.
template <ExponentialGroup G, Scalar S, class T>
ChartMidpoint<G, S> chart_midpoint_right(Element<G, S> const& g, Element<G, S> const& g1,
                                         Element<G, S> const& g2, T const& h) {
  // [eq_3_20]
  auto const first = natural_chart_right(g, g1), second = natural_chart_right(g, g2);
  return {(first + second) / S(2), (second - first) / detail::constant<S>(h)};
  // [eq_3_20]
}
/// The same in the chart by left translation.
template <ExponentialGroup G, Scalar S, class T>
ChartMidpoint<G, S> chart_midpoint_left(Element<G, S> const& g, Element<G, S> const& g1,
                                        Element<G, S> const& g2, T const& h) {
  auto const first = natural_chart_left(g, g1), second = natural_chart_left(g, g2);
  return {(first + second) / S(2), (second - first) / detail::constant<S>(h)};
}
/// \f$\mathrm{iex}(\mathrm{ad}_\eta)\,\zeta\f$: the velocity \f$\dot q q^{-1}\f$ of \f$q = e^\eta g\f$ when
/// \f$\eta\f$ changes at the rate \f$\zeta\f$.
template <Group G, Scalar S>
Velocity<G, S> fibre_element_right(ChartMidpoint<G, S> const& m) {
  // [claim_3_3_derivative_of_exponential]
  return {m.zeta.group, iex(ad_matrix(m.eta)) * m.zeta.coordinates};
  // [claim_3_3_derivative_of_exponential]
}
/// \f$\mathrm{iex}(-\mathrm{ad}_\eta)\,\zeta\f$: the velocity \f$q^{-1}\dot q\f$ of \f$q = g\,e^\eta\f$ when
/// \f$\eta\f$ changes at the rate \f$\zeta\f$.
template <Group G, Scalar S>
Velocity<G, S> fibre_element_left(ChartMidpoint<G, S> const& m) {
  return {m.zeta.group, iex(ad_matrix(-m.eta)) * m.zeta.coordinates};
}

/// \f$h\,L(q, \xi)\f$ with average and difference taken in the natural chart at a base point (right
/// translation): \f$q = e^\eta g\f$ and \f$\xi = \mathrm{iex}(\mathrm{ad}_\eta)\,\zeta\f$ of \ref
/// chart_midpoint_right. \f$\xi\f$ is the velocity at q translated to the identity on the right, so that this
/// is (3.20) with its push-forward carried out, (3.22).
///
/// \snippet reduction.cpp euler_lagrange_steps
///
/// \implements{eq_3_20}
/// @param L     Lagrangian on TG
/// @param h     step, time; not zero, negative to go back
/// @param base  (g1, g2) -> g, the base point of the chart, for instance \ref at_second
/// @return      (g1, g2) -> energy x time; order 2 in h
/// @throws OutsideDomain  at once for a step that is zero or not finite; when called, where a configuration
///                        is outside the chart at the base point
template <class Lagrangian, class T, class BasePoint>
auto discretize_right(Lagrangian L, T h, BasePoint base) {
  detail::nonzero_step(h);
  return [=]<class G, class S>(Element<G, S> const& g1, Element<G, S> const& g2) {
    Element<G, S> const g = base(g1, g2);
    // [eq_3_22]
    auto const m = chart_midpoint_right(g, g1, g2, h);
    return L(State<G, S>{exp(m.eta) * g, fibre_element_right(m)}) * detail::constant<S>(h);
    // [eq_3_22]
  };
}
/// The same with left translation: chart \f$\phi_g\f$, \f$q = g\,e^\eta\f$, body velocity
/// \f$\mathrm{iex}(-\mathrm{ad}_\eta)\,\zeta\f$ at q.
template <class Lagrangian, class T, class BasePoint>
auto discretize_left(Lagrangian L, T h, BasePoint base) {
  detail::nonzero_step(h);
  return [=]<class G, class S>(Element<G, S> const& g1, Element<G, S> const& g2) {
    Element<G, S> const g = base(g1, g2);
    auto const m = chart_midpoint_left(g, g1, g2, h);
    auto const q = g * exp(m.eta);
    return L(State<G, S>{q, Ad(q, fibre_element_left(m))}) * detail::constant<S>(h);
  };
}

/// Base points of the chart: the earlier configuration.
inline constexpr auto at_first = [](auto const& g1, auto const&) { return g1; };
/// Base points of the chart: the later configuration.
inline constexpr auto at_second = [](auto const&, auto const& g2) { return g2; };
/// Base points of the chart: a fixed fraction of the way from the earlier configuration to the later one
/// along \f$e^{t\xi}g_1\f$; 0 is \ref at_first, 1 \ref at_second. Equivariant under translations on either
/// side. All of these make the same discrete Lagrangian: average and difference commute.
template <class T>
auto at_fraction(T fraction) {
  return [fraction]<class G, class S>(Element<G, S> const& g1, Element<G, S> const& g2) {
    return exp(detail::constant<S>(fraction) * natural_chart_right(g1, g2)) * g1;
  };
}

/// The reduced discrete Lagrangian of a right-invariant system, chart at either end:
/// \f$\ell(f) = h\,l(-\log(f)/h)\f$, \f$f = g_0g_1^{-1}\f$.
///
/// The velocity points from g0 to g1 and f from g1 to g0: hence the sign, which the thesis drops.
/// \implements{eq_3_25}
/// @param l  reduced Lagrangian, function of \f$\dot g g^{-1}\f$, energy
/// @param h  step, time; not zero, negative to go back
template <class Reduced, class T>
auto natural_chart_lagrangian_right(Reduced l, T h) {
  detail::nonzero_step(h);
  return [=]<class G, class S>(Element<G, S> const& f) {
    S const step = detail::constant<S>(h);
    // [eq_3_25]
    return l(-log(f) / step) * step;
    // [eq_3_25]
  };
}
/// The reduced discrete Lagrangian of a left-invariant system: \f$\ell(f) = h\,l(-\log(f)/h)\f$ with
/// \f$f = g_1^{-1}g_0\f$ and l a function of \f$g^{-1}\dot g\f$.
///
/// \snippet reduction.cpp natural_chart_lagrangian_left
/// @param l  reduced Lagrangian, function of \f$g^{-1}\dot g\f$, energy
/// @param h  step, time; not zero, negative to go back
/// @throws OutsideDomain  at once for a step that is zero or not finite; when called, where f has no
///                        logarithm
template <class Reduced, class T>
auto natural_chart_lagrangian_left(Reduced l, T h) { return natural_chart_lagrangian_right(l, h); }

/// The reduced discrete Lagrangian of a right-invariant system, chart at any base point that is equivariant
/// under right translations: \f$\ell(f) = h\,l(\mathrm{iex}(\mathrm{ad}_\eta)\,\zeta)\f$ with
/// \f$\eta, \zeta\f$ of the pair \f$(f, e)\f$. Multiplication on the right has translated the later
/// configuration to the identity.
///
/// \implements{cor_3_3_1, eq_3_23}
/// @param l     reduced Lagrangian, function of \f$\dot g g^{-1}\f$, energy
/// @param h     step, time; not zero, negative to go back
/// @param base  (g1, g2) -> g with base(g1 k, g2 k) = base(g1, g2) k
template <class Reduced, class T, class BasePoint>
auto natural_chart_lagrangian_right(Reduced l, T h, BasePoint base) {
  detail::nonzero_step(h);
  return [=]<class G, class S>(Element<G, S> const& f) {
    auto const e = identity<S>(f.group);
    // [eq_3_23]
    auto const m = chart_midpoint_right(base(f, e), f, e, h);
    return l(fibre_element_right(m)) * detail::constant<S>(h);
    // [eq_3_23]
  };
}
/// The reduced discrete Lagrangian of a left-invariant system, chart at any base point that is equivariant
/// under left translations: \f$\ell(f) = h\,l(\mathrm{iex}(-\mathrm{ad}_\eta)\,\zeta)\f$.
template <class Reduced, class T, class BasePoint>
auto natural_chart_lagrangian_left(Reduced l, T h, BasePoint base) {
  detail::nonzero_step(h);
  return [=]<class G, class S>(Element<G, S> const& f) {
    auto const e = identity<S>(f.group);
    auto const m = chart_midpoint_left(base(f, e), f, e, h);
    return l(fibre_element_left(m)) * detail::constant<S>(h);
  };
}

}  // namespace actio
