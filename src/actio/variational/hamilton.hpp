// Hamilton's equations and the canonical bracket on T*G.
//
// A covector p at g is written (g, mu) with mu = T_e^*R_g p, translated to the identity on the right: the
// spatial momentum, what the thesis calls lambda(p). A function on T*G is any callable f(costate), at every
// scalar.
#pragma once

#include "actio/groups/differential.hpp"

namespace actio {

/// A point of T*G.
template <Group G, Scalar S>
struct Costate {
  using Scalar = S;
  Element<G, S> configuration;
  Momentum<G, S> momentum;  ///< \f$\mu = T_e^*R_g\,p\f$
};
/// A tangent vector to T*G.
template <Group G, Scalar S>
struct CostateChange {
  Velocity<G, S> configuration;  ///< \f$\vartheta = \delta g\,g^{-1}\f$
  Momentum<G, S> momentum;       ///< \f$\delta\mu\f$
};

/// The body momentum, \f$T_e^*L_g\,p = \mathrm{Ad}^*_g\,\mu\f$: what multiplication from the
/// right conserves.
template <Group G, Scalar S>
Momentum<G, S> body_momentum(Costate<G, S> const& p) {
  // [claim_2_2_reduced_motion]
  return Ad_star(p.configuration, p.momentum);
  // [claim_2_2_reduced_motion]
}

/// The same costate over a larger scalar, where it is a constant.
template <Scalar T, Group G, Scalar S>
Costate<G, T> over(Costate<G, S> const& p) { return {over<T>(p.configuration), over<T>(p.momentum)}; }

/// A costate moved infinitely little along a tangent vector.
template <Group G, Scalar S>
Costate<G, Dual<S>> moved(Costate<G, S> const& p, CostateChange<G, S> const& w) {
  using D = Dual<S>;
  Costate<G, D> result = over<D>(p);
  Coordinates<G, D> theta = Coordinates<G, D>::Zero(p.configuration.group.dimension());
  for (Index a = 0; a < theta.size(); ++a) {
    theta[a].part[0] = w.configuration.coordinates[a];
    result.momentum.components[a].part[0] = w.momentum.components[a];
  }
  result.configuration =
      Element<G, D>{p.configuration.group, primitive::near_identity(p.configuration.group, theta)} *
      result.configuration;
  return result;
}

/// \f$\partial H/\partial\mu\f$ at fixed configuration: a velocity.
template <Group G, Scalar S, class H>
Velocity<G, S> momentum_derivative(H const& h, Costate<G, S> const& p) {
  return gradient(
      [&](auto const& mu) {
        using T = typename std::decay_t<decltype(mu)>::Scalar;
        return h(Costate<G, T>{over<T>(p.configuration), mu});
      },
      p.momentum);
}
/// \f$\partial_gH\f$ at fixed \f$\mu\f$, translated to the identity on the right.
template <Group G, Scalar S, class H>
Momentum<G, S> base_derivative(H const& h, Costate<G, S> const& p) {
  return right_differential(
      [&](auto const& g) {
        using T = typename std::decay_t<decltype(g)>::Scalar;
        return h(Costate<G, T>{g, over<T>(p.momentum)});
      },
      p.configuration);
}

/// The canonical bracket on T*G with the sign \f$\{q, p\} = +1\f$:
/// \f[ \{F, H\} = \langle\partial_gF, H_\mu\rangle - \langle\partial_gH, F_\mu\rangle + \langle\mu, [F_\mu,
///   H_\mu]\rangle . \f]
template <Group G, Scalar S, class F, class H>
S canonical_bracket(F const& f, H const& h, Costate<G, S> const& p) {
  auto const f_mu = momentum_derivative(f, p), h_mu = momentum_derivative(h, p);
  return pair(base_derivative(f, p), h_mu) - pair(base_derivative(h, p), f_mu) +
         pair(p.momentum, bracket(f_mu, h_mu));
}

/// The Hamiltonian vector field: \f$\dot g g^{-1} = \partial H/\partial\mu\f$,
/// \f$\dot\mu = -\partial_gH - \mathrm{ad}^*_{\partial H/\partial\mu}\,\mu\f$.
///
/// \implements{claim_2_2_lie_poisson_equivalence}
template <Group G, Scalar S, class H>
CostateChange<G, S> hamiltonian_vector_field(H const& h, Costate<G, S> const& p) {
  // [claim_2_2_lie_poisson_equivalence]
  auto const xi = momentum_derivative(h, p);
  return {xi, -base_derivative(h, p) - ad_star(xi, p.momentum)};
  // [claim_2_2_lie_poisson_equivalence]
}

/// A right-invariant function on T*G from its restriction to the dual of the algebra:
/// \f$H(p) = h(\lambda(p))\f$.
template <class F>
auto right_invariant_function(F h) { return [h](auto const& p) { return h(p.momentum); }; }
/// A left-invariant function on T*G from its restriction: \f$H(p) = h(T_e^*L_g\,p)\f$.
template <class F>
auto left_invariant_function(F h) { return [h](auto const& p) { return h(body_momentum(p)); }; }

}  // namespace actio
