// The Legendre transformation of a Lagrangian on TG, its energy, and what makes it regular.
#pragma once

#include "actio/variational/state.hpp"

namespace actio {

/// \f$F L\f$: the momentum of a state, the derivative of L along the fibre, \f$\langle F L(v), \eta\rangle = \frac{d}{d\epsilon}L(g, \xi+\epsilon\eta)\f$.
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
S energy(Lagrangian const& L, State<G, S> const& v) {
  return pair(legendre(L, v), v.velocity) - L(v);
}

/// The matrix \f$\partial^2 L/\partial\xi\,\partial\xi\f$: L is regular where it has an inverse.
template <Group G, Scalar S, class Lagrangian>
auto fibre_hessian(Lagrangian const& L, State<G, S> const& v) {
  int const n = v.configuration.group.dimension();
  Matrix<S, G::dim, G::dim> hessian(n, n);
  over_batches(n, [&](int first) {
    State<G, Moved<S>> moved = over<Moved<S>>(v);
    for (int a = 0; a < batch && first + a < n; ++a) moved.velocity.coordinates[first + a].part[a] = S(1);
    store_parts(hessian, legendre(L, moved).components, first);
  });
  return hessian;
}

}  // namespace actio
