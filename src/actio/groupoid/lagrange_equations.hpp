// Mechanics on a groupoid: Lagrange equations, Legendre maps, and the map of the dual of the algebroid that a
// function generates.
//
// Two successive arrows g and h may be varied without changing their product, (g x)(x^-1 h) = gh with x near
// the unit of the point where they meet. A function L is stationary under these variations exactly if the
// momentum at the end of g is the momentum at the start of h.
#pragma once

#include "actio/groupoid/groupoid.hpp"
#include "actio/groups/solve.hpp"

namespace actio {

namespace detail {
/// Component a: the rate of `f(near_unit(x, v))` along the a-th direction of the algebroid over x.
template <Groupoid Gamma, Scalar S, class F>
Fibre<Gamma, S> fibre_differential(Gamma const& gamma, Point<Gamma, Moved<S>> const& x, F const& f,
                                   char const* where) {
  auto const d = derivative([&](Fibre<Gamma, Moved<S>> const& v) { return f(gamma.near_unit(x, v)); },
                            Fibre<Gamma, S>(Fibre<Gamma, S>::Zero(gamma.dimension())));
  require_number(d, where);
  return d.gradient();
}
}  // namespace detail

/// \f$\tilde\beta\circ dL\f$: the momentum at the end of the arrow g,
/// \f$v\mapsto\frac{d}{d\epsilon}L(g\,x_\epsilon)\f$ with \f$x_\epsilon\f$ leaving the target of g along v.
///
/// On pairs it is \f$D_2L\f$, on a group \f$L_g^*\ell'(g)\f$.
/// \implements{claim_4_2_left_legendre_map}
/// @param l  function of arrows, at every scalar; energy x time
/// Exact up to rounding.
template <Groupoid Gamma, class L, class A>
auto legendre_at_target(Gamma const& gamma, L const& l, A const& g) {
  using S = typename A::Scalar;
  auto const wide = gamma.template over<Moved<S>>(g);
  return DualPoint<Gamma, S>{
      gamma.target(g), detail::fibre_differential<Gamma, S>(
                           gamma, gamma.target(wide),
                           [&](auto const& x) { return l(gamma.compose(wide, x)); }, "legendre_at_target")};
}

/// \f$\tilde\alpha\circ dL\f$: the momentum at the start of the arrow h,
/// \f$v\mapsto-\frac{d}{d\epsilon}L(x_\epsilon^{-1}h)\f$ with \f$x_\epsilon\f$ leaving the source of h along
/// v.
///
/// On pairs it is \f$-D_1L\f$, on a group \f$R_h^*\ell'(h)\f$.
/// \implements{claim_4_3_legendre_map_value}
template <Groupoid Gamma, class L, class A>
auto legendre_at_source(Gamma const& gamma, L const& l, A const& h) {
  using S = typename A::Scalar;
  auto const wide = gamma.template over<Moved<S>>(h);
  auto d = detail::fibre_differential<Gamma, S>(
      gamma, gamma.source(wide), [&](auto const& x) { return l(gamma.compose(gamma.inverse(x), wide)); },
      "legendre_at_source");
  return DualPoint<Gamma, S>{gamma.source(h), -d};
}

/// The residual of the Lagrange equations on a groupoid: zero where \f$L(g)+L(h)\f$ is stationary among pairs
/// with the product gh, and only there.
///
/// \f[ \tilde\beta(dL(g)) - \tilde\alpha(dL(h)), \qquad \beta(g) = \alpha(h) \f]
///
/// On \f$G\times G\f$ this is (3.2), on G it is minus (3.10) with \f$g = f_{01}\f$, \f$h = f_{12}\f$, and on
/// the opposite of G it is minus (3.11) with \f$g = f_{10}\f$, \f$h = f_{21}\f$: \f$g_0g_1^{-1}\f$ turns
/// pairs into group elements and products into products, but leads from the later configuration to the
/// earlier, so that a velocity changes its sign.
///
/// \snippet reduction.cpp lagrange_equations
///
/// \implements{def_4_1_1}
/// @param g, h  composable: the target of g is the source of h
/// @return      covector on the fibre of the algebroid over the point where they meet
template <Groupoid Gamma, class L, class A>
auto lagrange_equations(Gamma const& gamma, L const& l, A const& g, A const& h) {
  // [def_4_1_1]
  auto const arrival = legendre_at_target(gamma, l, g), departure = legendre_at_source(gamma, l, h);
  return (arrival.components - departure.components).eval();
  // [def_4_1_1]
}

/// An arrow from the source of `start` that leaves it with the covector p: solves
/// \f$\tilde\alpha(dL(h)) = p\f$ by Newton's iteration on the arrows from one point.
///
/// Stops as \ref solve_on_group does.
/// @throws Singular      where L is not regular
/// @throws NotConverged  where the covector is too large for the step, with the history of residuals
/// @throws NotFinite     where p or `start` is no number
template <ExponentialGroupoid Gamma, class L, class A>
Solved<A> arrow_with_source_covector(Gamma const& gamma, L const& l,
                                     Fibre<Gamma, typename A::Scalar> const& p, A const& start,
                                     int limit = 60) {
  using S = typename A::Scalar;
  int const n = gamma.dimension();
  require_finite(p, "arrow_with_source_covector: covector");
  Solved<A> found{start, {}};
  Report& report = found.report;
  report.tolerance = 16 * to_double(epsilon<S>());
  Fibre<Gamma, S> const still = Fibre<Gamma, S>::Zero(n);
  for (int iteration = 0; iteration < limit; ++iteration) {
    // The residual on arrows moved infinitely little at their free end: value and derivative at once.
    auto const wide = gamma.template over<Moved<S>>(found.value);
    auto const covector = [&](Fibre<Gamma, Moved<S>> const& v) -> Fibre<Gamma, Moved<S>> {
      return legendre_at_source(gamma, l, gamma.compose(wide, gamma.near_unit(gamma.target(wide), v)))
          .components;
    };
    auto const moved = derivative(covector, still);
    Fibre<Gamma, S> const value = moved.value - p;
    auto const& slope = moved.matrix;
    ++report.evaluations;
    if (!is_finite(value) || !is_finite(slope))
      throw NotFinite("arrow_with_source_covector: residual or its derivative");
    double const before = report.residuals.empty() ? HUGE_VAL : report.residuals.back();
    double const size = relative_residual(value, slope);
    report.residuals.push_back(size);
    bool const done = size <= report.tolerance || (size <= 64 * report.tolerance && size > before / 2);
    Fibre<Gamma, S> update = solve_linear(slope, Fibre<Gamma, S>(-value),
                                          "arrow_with_source_covector: derivative of the residual");
    if (S const length = magnitude(update); length > S(1)) update /= length;
    found.value = gamma.compose(found.value, gamma.leave(gamma.target(found.value), update));
    if (done) return found;
  }
  throw NotConverged("arrow_with_source_covector", report.residuals, report.tolerance);
}

/// \f$\Sigma_L\f$: the arrow after g, starting from `guess`, an arrow from the target of g. Solves
/// \ref lagrange_equations for h.
/// @throws Singular, NotConverged, NotFinite  as \ref arrow_with_source_covector
template <ExponentialGroupoid Gamma, class L, class A>
Solved<A> step_lagrange(Gamma const& gamma, L const& l, A const& g, A const& guess) {
  return arrow_with_source_covector(gamma, l, legendre_at_target(gamma, l, g).components, guess);
}

/// \f$\Lambda_L = \tilde\beta\circ dL\circ(\tilde\alpha\circ dL)^{-1}\f$: the map of the dual of the
/// algebroid that a function generates. It is a Poisson map.
///
/// \implements{def_4_1_2}
/// @param p      a point of the dual of the algebroid
/// @param guess  an arrow from the base point of p
/// @throws Singular, NotConverged, NotFinite  as \ref arrow_with_source_covector
template <ExponentialGroupoid Gamma, class L, class A>
DualPoint<Gamma, typename A::Scalar> generated_map(Gamma const& gamma, L const& l,
                                                   DualPoint<Gamma, typename A::Scalar> const& p,
                                                   A const& guess) {
  // [def_4_1_2]
  auto const h = arrow_with_source_covector(gamma, l, p.components, guess).value;
  return legendre_at_target(gamma, l, h);
  // [def_4_1_2]
}

}  // namespace actio
