// Maps small enough to know all about, for the tests of this folder.
#pragma once

#include "actio/groups/unipotent_groups.hpp"
#include "actio/instruments/implicit_map.hpp"

namespace actio::testing {

inline constexpr double eps = std::numeric_limits<double>::epsilon();

/// \f$\mathrm{ad}^*_{I^{-1}\Pi}\,\Pi\f$: a free body on any group with a diagonal inertia of whole numbers.
template <Group G>
struct DiagonalBody {
  Coordinates<G, double> inertia;

  template <Scalar S>
  Velocity<G, S> velocity(Momentum<G, S> const& pi) const {
    return {pi.group, pi.components.cwiseQuotient(inertia.template cast<S>())};
  }
  template <Scalar S>
  Momentum<G, S> rate(Momentum<G, S> const& pi) const { return ad_star(velocity(pi), pi); }
};

/// One step of the classical Runge-Kutta method for the body momentum.
template <Group G, Scalar S>
Momentum<G, S> runge_kutta(DiagonalBody<G> const& body, S const& h, Momentum<G, S> const& pi) {
  auto const k1 = body.rate(pi), k2 = body.rate(pi + h / S(2) * k1), k3 = body.rate(pi + h / S(2) * k2),
             k4 = body.rate(pi + h * k3);
  return pi + h / S(6) * (k1 + S(2) * k2 + S(2) * k3 + k4);
}

/// One step of the implicit midpoint rule.
template <Group G, Scalar S>
Momentum<G, S> implicit_midpoint(DiagonalBody<G> const& body, S const& h, Momentum<G, S> const& pi) {
  using Space = Translations<G::dim>;
  auto const residual = [&](auto const& y, auto const& p) {
    using T = typename std::decay_t<decltype(y)>::Scalar;
    auto const& [step, start] = p;
    Momentum<G, T> const from = over<T>(start), to{start.group, y.value};
    return Momentum<Space, T>{{}, (to - from - T(step) * body.rate((from + to) / T(2))).components};
  };
  return {pi.group, solve_implicit(residual, std::tuple(h, pi), Element<Space, S>{{}, pi.components}).value};
}

/// The classical splitting into the flows of the Hamiltonians \f$\Pi_a^2/2I_a\f$, each exact, forwards and
/// backwards by half a step.
template <ExponentialGroup G, Real S>
Momentum<G, S> splitting(DiagonalBody<G> const& body, S const& h, Momentum<G, S> pi) {
  int const n = pi.group.dimension();
  auto const turn = [&](int a, S const& time) {
    pi = Ad_star(exp(time * body.velocity(pi).coordinates[a] * basis_velocity<S>(pi.group, a)), pi);
  };
  for (int a = 0; a < n; ++a) turn(a, h / S(2));
  for (int a = n - 1; a >= 0; --a) turn(a, h / S(2));
  return pi;
}

/// The reduced discrete Lagrangian of the body, \f$\frac1{2h}\langle I\log f, \log f\rangle\f$, which any h
/// but zero may enter.
template <Group G, class T>
auto chart_lagrangian(DiagonalBody<G> const& body, T const& h) {
  return [body, h](auto const& f) {
    using S = typename std::decay_t<decltype(f)>::Scalar;
    auto const eta = log(f).coordinates;
    S sum(0);
    for (Index a = 0; a < eta.size(); ++a) sum += eta[a] * eta[a] * Base<S>(body.inertia[a]);
    return S(sum / (S(2) * S(h)));
  };
}

}  // namespace actio::testing
