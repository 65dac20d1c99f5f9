// Discretization by natural charts: a continuous Lagrangian becomes a discrete one through the exponential map (thesis, section 3.3).
//
// The chart at g is psi_g(k) = log(k g^-1) for right translation, phi_g(k) = log(g^-1 k) for left translation. Two places are averaged and
// subtracted in it. A discrete Lagrangian is an action: the step times the Lagrangian.
#pragma once

#include "actio/reduction/relative_motion.hpp"
#include "actio/variational/state.hpp"

namespace actio {

/// \f$\psi_g(k) = \log(k\,g^{-1})\f$, the natural chart at g by right translation.
///
/// \implements{eq_3_19}
/// @throws OutsideDomain  where k is outside the chart
template <ExponentialGroup G, Real S>
Velocity<G, S> natural_chart_right(Element<G, S> const& g, Element<G, S> const& k) {
  // [eq_3_19]
  return log(k * inverse(g));
  // [eq_3_19]
}
/// \f$\phi_g(k) = \log(g^{-1}k)\f$, the natural chart at g by left translation.
template <ExponentialGroup G, Real S>
Velocity<G, S> natural_chart_left(Element<G, S> const& g, Element<G, S> const& k) {
  return log(inverse(g) * k);
}

/// \f$h\,L(q, \cdot)\f$ with average and difference taken in the natural chart at a base point (right translation).
///
/// \f[ \eta = \tfrac12(\psi_g(g_1)+\psi_g(g_2)),\quad \zeta = \tfrac1h(\psi_g(g_2)-\psi_g(g_1)),\quad q = e^\eta g,\quad \xi = \mathrm{iex}(\mathrm{ad}_\eta)\,\zeta \f]
/// \f$\xi\f$ is the velocity at q carried to the identity on the right, so that this is (3.20) with its push-forward carried out, (3.22).
///
/// \implements{eq_3_20}
/// @param L     Lagrangian on TG
/// @param h     step, time; positive
/// @param base  (g1, g2) -> g, the base point of the chart, for instance \ref at_second
/// @return      (g1, g2) -> energy x time
template <class Lagrangian, class T, class BasePoint>
auto discretize_right(Lagrangian L, T h, BasePoint base) {
  return [=](auto const& g1, auto const& g2) {
    using Place = std::decay_t<decltype(g1)>;
    using G = typename Place::GroupType;
    using S = typename Place::Scalar;
    Place const g = base(g1, g2);
    auto const first = natural_chart_right(g, g1), second = natural_chart_right(g, g2);
    // [eq_3_22]
    auto const eta = (first + second) / S(2);
    auto const zeta = (second - first) / S(h);
    Velocity<G, S> const fibre{g.group, iex(ad_matrix(eta)) * zeta.coordinates};
    return L(State<G, S>{exp(eta) * g, fibre}) * S(h);
    // [eq_3_22]
  };
}

/// The same with left translation: chart \f$\phi_g\f$, \f$q = g\,e^\eta\f$, body velocity \f$\mathrm{iex}(-\mathrm{ad}_\eta)\,\zeta\f$ at q.
template <class Lagrangian, class T, class BasePoint>
auto discretize_left(Lagrangian L, T h, BasePoint base) {
  return [=](auto const& g1, auto const& g2) {
    using Place = std::decay_t<decltype(g1)>;
    using G = typename Place::GroupType;
    using S = typename Place::Scalar;
    Place const g = base(g1, g2);
    auto const first = natural_chart_left(g, g1), second = natural_chart_left(g, g2);
    auto const eta = (first + second) / S(2);
    auto const zeta = (second - first) / S(h);
    Velocity<G, S> const body{g.group, iex(ad_matrix(-eta)) * zeta.coordinates};
    Place const q = g * exp(eta);
    return L(State<G, S>{q, Ad(q, body)}) * S(h);
  };
}

/// Base points of the chart.
inline constexpr auto at_first = [](auto const& g1, auto const&) { return g1; };
inline constexpr auto at_second = [](auto const&, auto const& g2) { return g2; };

/// The reduced discrete Lagrangian of a right-invariant system, chart at either end: \f$\ell(f) = h\,l(-\log(f)/h)\f$, \f$f = g_0g_1^{-1}\f$.
///
/// The velocity points from g0 to g1 and f from g1 to g0: hence the sign, which print drops.
/// \implements{eq_3_25}
/// @param l  reduced Lagrangian, function of \f$\dot g g^{-1}\f$, energy
/// @param h  step, time
template <class Reduced, class T>
auto natural_chart_lagrangian_right(Reduced l, T h) {
  return [=](auto const& f) {
    using S = typename std::decay_t<decltype(f)>::Scalar;
    // [eq_3_25]
    return l(log(f) / S(-h)) * S(h);
    // [eq_3_25]
  };
}
/// The reduced discrete Lagrangian of a left-invariant system: \f$\ell(f) = h\,l(-\log(f)/h)\f$ with \f$f = g_1^{-1}g_0\f$ and l a function of \f$g^{-1}\dot g\f$.
template <class Reduced, class T>
auto natural_chart_lagrangian_left(Reduced l, T h) {
  return natural_chart_lagrangian_right(l, h);
}

}  // namespace actio
