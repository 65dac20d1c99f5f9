// Galerkin steps with a vector that the motion advects.
//
// Along a path the vector is a = e^-eta a0 (left-invariant) or e^eta a0 (right-invariant), and the Lagrangian
// l(xi, a) has a torque J, <J, theta> = <dl/da, theta a>, so that p changes at the rate +- (ad*_xi p - J). By
// the same path the symmetry is broken over the step: the momentum at its end is that at its start, less the
// torques along the way, transported by Ad*. Momentum and vector move on a coadjoint orbit of the semidirect
// product, and the bracket is preserved.
#pragma once

#include "actio/reduction/advected_momentum_level.hpp"
#include "actio/reduction/galerkin.hpp"

namespace actio {

namespace detail {

/// A Galerkin step with an advected vector; side: +1 right, -1 left.
template <int side, class F, Real B, class Act>
struct AdvectedGalerkinStep {
  F l;
  PolynomialPath<B> path;
  Act act;
  RememberedSolutions remembered = {};

  template <ExponentialGroup G, Real S, int m>
  AdvectedMomentumStep<G, S, m> operator()(AdvectedMomentumState<G, S, m> const& from,
                                           std::type_identity_t<B> const& h) const {
    require_steppable(MomentumState<G, S>{from.momentum, from.velocity}, h);
    require_finite(from.vector, "momentum step: vector");
    auto const& group = from.momentum.group;
    int evaluations = 0;
    auto const xi = solve_galerkin(
        remembered, from.velocity, h, path.degree(),
        [&]<class R>(Matrix<R, Dynamic, 1> const& x) { return residual(from, h, x).second; }, evaluations);
    auto const mu = residual(from, h, xi).first;
    auto const f = exp(Velocity<G, S>{group, -xi.tail(group.dimension())});
    using Invariance = std::conditional_t<(side > 0), RightInvariant, LeftInvariant>;
    return {f,
            {Invariance::lie_poisson_update(f, mu), act(side > 0 ? inverse(f) : f, from.vector),
             velocity_at_end<side>(path, group, h, xi)},
            evaluations};
  }

 private:
  /// The momentum at the start less the torques along the path, and the numbers that vanish.
  template <Group G, Real S, int m, Scalar R>
  std::pair<Momentum<G, R>, Matrix<R, Dynamic, 1>> residual(AdvectedMomentumState<G, S, m> const& from,
                                                            B const& h,
                                                            Matrix<R, Dynamic, 1> const& x) const {
    auto mu = over<R>(from.momentum);
    Matrix<R, m, 1> const a0 = from.vector.template cast<R>();
    // [advected_galerkin]
    auto const at_node = [&](int i, auto const& eta, Velocity<G, R> const& velocity) {
      Velocity<G, R> moved = velocity;
      for (Index k = 0; k < moved.coordinates.size(); ++k)
        moved.coordinates[k] = eta.coordinates[k].value * B(side);
      auto const along = exp(moved);  // of the path, as it acts on vectors
      Matrix<R, m, 1> const a = act(along, a0);
      auto const torque = advected_differential(
          [&](auto const& g, auto const& vector) { return l(like(g, velocity), vector); },
          identity<R>(velocity.group), a, act);
      mu = mu + R(h * path.weights[i] * B(side)) * Ad_star(along, torque);
      return AtNode<G, R>{gradient(holding(l, a), velocity), R(h) * torque};
    };
    // [advected_galerkin]
    auto left = galerkin_residual<side>(at_node, path, mu, h, x);
    return {mu, left};
  }
};

}  // namespace detail

/// The Galerkin step of a left-invariant system with an advected vector, of order 2s: a callable
/// (state, h) -> \ref AdvectedMomentumStep.
///
/// With s = 1 and a Lagrangian without the vector it is that of \ref galerkin_step_left.
/// @param l    reduced Lagrangian, function of \f$g^{-1}\dot g\f$ and of \f$a = g^{-1}c\f$, energy
/// @param s    degree and number of nodes, 1 to 8
/// @param act  the action of the group on vectors
/// @throws OutsideDomain  at once for a degree that is none of these; when called, for a step that is zero or
///                        not finite, or leaves every chart
/// @throws NotConverged, Singular  when called, where the step is too long for the momentum
template <Real S, class F, class Act = MatrixAction>
auto advected_galerkin_step_left(F l, int s, Act act = {}) {
  return detail::AdvectedGalerkinStep<-1, F, S, Act>{std::move(l), PolynomialPath<S>(s), std::move(act)};
}
/// The same of a right-invariant system, with \f$a = g\,c\f$.
/// @param l  reduced Lagrangian, function of \f$\dot g g^{-1}\f$ and of a, energy
/// @param s  degree and number of nodes, 1 to 8
template <Real S, class F, class Act = MatrixAction>
auto advected_galerkin_step_right(F l, int s, Act act = {}) {
  return detail::AdvectedGalerkinStep<1, F, S, Act>{std::move(l), PolynomialPath<S>(s), std::move(act)};
}

}  // namespace actio
