// The Poisson structure that a function puts on a group: the Lie-Poisson bracket, pulled back along a
// Legendre map. Its leaves are invariant manifolds of the discrete motion.
//
// With the group as a groupoid the Legendre maps of l are f -> R*_f l'(f) and f -> L*_f l'(f). Where the
// second derivative of l has an inverse they are local diffeomorphisms into the dual of the algebra, and both
// pull back the same bracket. Coordinates at f are those of \f$\delta f\,f^{-1}\f$.
#pragma once

#include "actio/linear_algebra/rank.hpp"
#include "actio/reduction/discrete_euler_poincare.hpp"
#include "actio/variational/coadjoint_orbit.hpp"
#include "actio/variational/lie_poisson.hpp"

namespace actio {

/// The bracket on G at f by pull-back of the plus bracket along \f$f\mapsto R_f^*\ell'(f)\f$:
/// \f$\{a, b\}(f) = (R_f^*a')^T\,P\,(R_f^*b')\f$.
///
/// \f[ P = A^{-1}\,\Pi_+(R_f^*\ell')\,A^{-T}, \qquad A\vartheta = \delta(R_f^*\ell') \f]
/// \implements{claim_4_1_poisson_on_group}
/// @throws Singular  where l is not regular at f: the structure is local
template <Group G, Scalar S, class F>
auto legendre_bivector_right(F const& l, Element<G, S> const& f) {
  // [claim_4_1_poisson_on_group]
  auto const back = inverse_matrix(right_second_differential(l, f), "Poisson structure on the group: l''");
  return (back * lie_poisson_tensor_plus(right_differential(l, f)) * back.transpose()).eval();
  // [claim_4_1_poisson_on_group]
}
/// The same by pull-back along \f$f\mapsto L_f^*\ell'(f)\f$. It is equal to \ref legendre_bivector_right :
/// the one map follows the other by a Poisson map.
/// @throws Singular  where l is not regular at f
template <Group G, Scalar S, class F>
auto legendre_bivector_left(F const& l, Element<G, S> const& f) {
  auto const back = inverse_matrix(left_second_differential(l, f), "Poisson structure on the group: l''");
  return (back * lie_poisson_tensor_plus(left_differential(l, f)) * back.transpose()).eval();
}

/// A tangent vector of the leaf through f, \f$\delta f\,f^{-1}\f$: the one along which
/// \f$\mu = -R_f^*\ell'(f)\f$ moves by \f$-\mathrm{ad}^*_\eta\mu\f$, as a motion with the velocity \f$\eta\f$
/// moves it.
/// @throws Singular  where l is not regular at f
template <Group G, Scalar S, class F>
Velocity<G, S> leaf_vector(F const& l, Element<G, S> const& f, Velocity<G, S> const& eta) {
  auto const rate = ad_star(eta, -right_differential(l, f)).components;
  return {f.group, solve_linear(right_second_differential(l, f), rate, "leaf_vector: l''")};
}

/// The symplectic form of the leaf through f on two of its tangent vectors: the form of the coadjoint orbit
/// of \f$\mu = -R_f^*\ell'(f)\f$, on their images.
///
/// \implements{eq_4_10}
/// @throws OutsideDomain  where a vector is not tangent to the leaf
template <Group G, Scalar S, class F>
S leaf_form(F const& l, Element<G, S> const& f, Velocity<G, S> const& u, Velocity<G, S> const& v) {
  auto const image = [&, a = right_second_differential(l, f)](Velocity<G, S> const& w) {
    return Momentum<G, S>{f.group, -(a * w.coordinates)};
  };
  // [eq_4_10]
  return kirillov_kostant_plus(-right_differential(l, f), image(u), image(v));
  // [eq_4_10]
}

}  // namespace actio
