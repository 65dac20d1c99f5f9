// The Legendre transformation of a Lagrangian on TG, its energy, and what makes it regular.
#pragma once

#include "actio/variational/state.hpp"

namespace actio {

/// \f$F L\f$: the momentum of a state, the derivative of L along the fibre, \f$\langle F L(v),
/// \eta\rangle = \frac{d}{d\epsilon}L(g, \xi+\epsilon\eta)\f$.
///
/// Translated to the identity on the right, as the velocity is: the spatial momentum.
/// @param L  Lagrangian, energy
template <Group G, Scalar S, class Lagrangian>
Momentum<G, S> legendre(Lagrangian const& L, State<G, S> const& v) {
  return gradient(
      [&](auto const& xi) {
        using T = typename std::decay_t<decltype(xi)>::Scalar;
        return L(State<G, T>{over<T>(v.configuration), xi});
      },
      v.velocity);
}

/// The derivative of L along the base, with the right-translated velocity held fixed:
/// \f$\langle\cdot, \vartheta\rangle = \frac{d}{d\epsilon}L(e^{\epsilon\vartheta}g, \xi)\f$.
template <Group G, Scalar S, class Lagrangian>
Momentum<G, S> base_derivative(Lagrangian const& L, State<G, S> const& v) {
  return right_differential(
      [&](auto const& g) {
        using T = typename std::decay_t<decltype(g)>::Scalar;
        return L(State<G, T>{g, over<T>(v.velocity)});
      },
      v.configuration);
}

/// \f$E(v) = \langle F L(v), v\rangle - L(v)\f$.
template <Group G, Scalar S, class Lagrangian>
S energy(Lagrangian const& L, State<G, S> const& v) { return pair(legendre(L, v), v.velocity) - L(v); }

/// The matrix \f$\partial^2 L/\partial\xi\,\partial\xi\f$: L is regular where it has an inverse.
template <Group G, Scalar S, class Lagrangian>
auto fibre_hessian(Lagrangian const& L, State<G, S> const& v) {
  auto const momentum = [&]<class T>(Matrix<T, G::dim, 1> const& velocity) -> Matrix<T, G::dim, 1> {
    State<G, T> moved = over<T>(v);
    moved.velocity.coordinates = velocity;
    return legendre(L, moved).components;
  };
  return derivative(momentum, v.velocity.coordinates).matrix;
}

}  // namespace actio
