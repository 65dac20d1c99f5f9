// The Euler-Poincare equations: the motion of an invariant system, in the algebra alone.
//
// The velocity of a right-invariant system is xi = g' g^-1, that of a left-invariant one xi = g^-1 g'. The
// two have equations of opposite sign; each has its own function.
#pragma once

#include "actio/groups/differential.hpp"

namespace actio {

namespace detail {
/// The rate of the momentum \f$\partial l/\partial\xi\f$ while \f$\xi\f$ changes at the given rate.
template <Group G, Scalar S, class F>
Momentum<G, S> momentum_rate(F const& l, Velocity<G, S> const& xi, Velocity<G, S> const& acceleration) {
  int const n = xi.group.dimension();
  Velocity<G, Dual<S>> along = over<Dual<S>>(xi);
  for (int a = 0; a < n; ++a) along.coordinates[a].part[0] = acceleration.coordinates[a];
  auto const mu = gradient(l, along);
  Momentum<G, S> rate{xi.group, Coordinates<G, S>(n)};
  for (int a = 0; a < n; ++a) rate.components[a] = mu.components[a].part[0];
  return rate;
}
}  // namespace detail

/// The residual of the Euler-Poincare equations of a right-invariant system:
/// \f[ \frac{d}{dt}\frac{\partial l}{\partial\xi} + \mathrm{ad}^*_\xi\frac{\partial l}{\partial\xi} . \f]
///
/// \implements{thm_2_2_1}
/// @param l             reduced Lagrangian on the algebra, energy
/// @param xi            \f$\dot g g^{-1}\f$, 1/time
/// @param acceleration  \f$\dot\xi\f$
template <Group G, Scalar S, class F>
Momentum<G, S> euler_poincare_right(F const& l, Velocity<G, S> const& xi,
                                    Velocity<G, S> const& acceleration) {
  // [thm_2_2_1]
  return detail::momentum_rate(l, xi, acceleration) + ad_star(xi, gradient(l, xi));
  // [thm_2_2_1]
}

/// The residual of the Euler-Poincare equations of a left-invariant system:
/// \f[ \frac{d}{dt}\frac{\partial l}{\partial\xi} - \mathrm{ad}^*_\xi\frac{\partial l}{\partial\xi} . \f]
///
/// @param l             reduced Lagrangian on the algebra, energy
/// @param xi            \f$g^{-1}\dot g\f$, 1/time
/// @param acceleration  \f$\dot\xi\f$
template <Group G, Scalar S, class F>
Momentum<G, S> euler_poincare_left(F const& l, Velocity<G, S> const& xi, Velocity<G, S> const& acceleration) {
  return detail::momentum_rate(l, xi, acceleration) - ad_star(xi, gradient(l, xi));
}

/// The matrix \f$\partial^2 l/\partial\xi\,\partial\xi\f$ of a reduced Lagrangian.
template <Group G, Scalar S, class F>
auto hessian(F const& l, Velocity<G, S> const& xi) {
  auto const momentum = [&]<class T>(Matrix<T, G::dim, 1> const& moved) -> Matrix<T, G::dim, 1> {
    return gradient(l, Velocity<G, T>{xi.group, moved}).components;
  };
  return derivative(momentum, xi.coordinates).matrix;
}

/// \f$\dot\xi\f$ of a right-invariant system.
/// @throws Singular  where l is not regular
template <Group G, Scalar S, class F>
Velocity<G, S> euler_poincare_acceleration_right(F const& l, Velocity<G, S> const& xi) {
  return {xi.group, solve_linear(hessian(l, xi), (-ad_star(xi, gradient(l, xi))).components,
                                 "euler_poincare: d2l/dxi2")};
}
/// \f$\dot\xi\f$ of a left-invariant system.
///
/// \snippet bodies.cpp euler_poincare
/// @throws Singular  where l is not regular
template <Group G, Scalar S, class F>
Velocity<G, S> euler_poincare_acceleration_left(F const& l, Velocity<G, S> const& xi) {
  return {xi.group,
          solve_linear(hessian(l, xi), ad_star(xi, gradient(l, xi)).components, "euler_poincare: d2l/dxi2")};
}

/// The variation of \f$\xi = \dot g g^{-1}\f$ when g varies by \f$\eta = \delta g\,g^{-1}\f$:
/// \f$\dot\eta - [\xi, \eta]\f$.
///
/// \implements{claim_2_2_reduced_variation_ad}
template <Group G, Scalar S>
Velocity<G, S> reduced_variation_right(Velocity<G, S> const& xi, Velocity<G, S> const& eta,
                                       Velocity<G, S> const& eta_rate) {
  // [claim_2_2_reduced_variation_ad]
  return eta_rate - ad(xi, eta);
  // [claim_2_2_reduced_variation_ad]
}
/// The variation of \f$\xi = g^{-1}\dot g\f$ when g varies by \f$\eta = g^{-1}\delta g\f$:
/// \f$\dot\eta + [\xi, \eta]\f$.
template <Group G, Scalar S>
Velocity<G, S> reduced_variation_left(Velocity<G, S> const& xi, Velocity<G, S> const& eta,
                                      Velocity<G, S> const& eta_rate) {
  return eta_rate + ad(xi, eta);
}

}  // namespace actio
