// The Euler-Lagrange equations of a Lagrangian on TG, without coordinates.
//
// Translated to the identity on the right, the variation of a curve is theta = dg g^-1 and that of its
// velocity is theta' - [xi, theta]. The covector that is paired with theta after integration by parts is the
// Euler-Lagrange map; the boundary term is the Lagrange one-form.
#pragma once

#include "actio/variational/legendre.hpp"

namespace actio {

/// The Euler-Lagrange map \f$D_{EL}L\f$ at a second-order jet (g, xi, xi'), a covector: zero along motions,
/// and only there.
///
/// \f[ \partial_g L \;-\; \mathrm{ad}^*_\xi\,\mu \;-\; \frac{d\mu}{dt}, \qquad \mu = F L(g, \xi) \f]
///
/// In a chart this is (2.4); here the base derivative and the momentum are translated to the identity on the
/// right.
///
/// \snippet bodies.cpp euler_lagrange
///
/// \implements{eq_2_4}
/// @param L             Lagrangian on TG, energy
/// @param v             state
/// @param acceleration  \f$\dot\xi\f$, 1/time^2
/// Exact up to rounding.
template <Group G, Scalar S, class Lagrangian>
Momentum<G, S> euler_lagrange(Lagrangian const& L, State<G, S> const& v, Velocity<G, S> const& acceleration) {
  // The rate of the momentum along the curve: the curve's own direction in TG is (xi, xi').
  auto const along = legendre(L, moved(v, {v.velocity, acceleration}));
  Momentum<G, S> rate{v.configuration.group, Coordinates<G, S>(v.configuration.group.dimension())};
  for (Index a = 0; a < rate.components.size(); ++a) rate.components[a] = along.components[a].part[0];

  auto const mu = legendre(L, v);
  // [eq_2_4]
  return base_derivative(L, v) - ad_star(v.velocity, mu) - rate;
  // [eq_2_4]
}

/// The acceleration \f$\dot\xi\f$ that a regular Lagrangian gives a state: the Lagrange vector field is
/// \f$(\xi, \dot\xi)\f$.
///
/// \snippet bodies.cpp euler_lagrange
///
/// \implements{claim_2_1_lagrange_vector_field}
/// @throws Singular  where L is not regular
template <Group G, Scalar S, class Lagrangian>
Velocity<G, S> lagrange_acceleration(Lagrangian const& L, State<G, S> const& v) {
  // The equation is affine in the acceleration: residual at zero, and the fibre Hessian beside it.
  Velocity<G, S> const none{v.configuration.group,
                            Coordinates<G, S>::Zero(v.configuration.group.dimension())};
  auto const force = euler_lagrange(L, v, none);
  // [claim_2_1_regular_second_order_ode]
  return {v.configuration.group,
          solve_linear(fibre_hessian(L, v), force.components, "lagrange_acceleration: d2L/dxi2")};
  // [claim_2_1_regular_second_order_ode]
}

/// The Lagrange vector field \f$X_E\f$ as a tangent vector to TG at v.
template <Group G, Scalar S, class Lagrangian>
StateChange<G, S> lagrange_vector_field(Lagrangian const& L, State<G, S> const& v) {
  // [claim_2_1_lagrange_vector_field]
  return {v.velocity, lagrange_acceleration(L, v)};
  // [claim_2_1_lagrange_vector_field]
}

}  // namespace actio
