// Galerkin steps with a vector that the motion advects.
//
// Along a path the vector is a = e^-eta a0 (left-invariant) or e^eta a0 (right-invariant), and the Lagrangian
// l(xi, a) has a torque J, <J, theta> = <dl/da, theta a>, so that p changes at the rate +- (ad*_xi p - J). By
// the same path the symmetry is broken over the step: the momentum at its end is that at its start, less the
// torques along the way, transported by Ad*. Momentum and vector move on a coadjoint orbit of the semidirect
// product, and the bracket is preserved.
//
// A force F enters by its work on variations, with the weights of the rule: it is a torque -F
// (left-invariant) or F (right-invariant) more, and the order stays.
#pragma once

#include "actio/reduction/advected_momentum_level.hpp"
#include "actio/reduction/galerkin.hpp"

namespace actio {

namespace detail {

/// No force.
struct NoForce {};

/// A Galerkin step with an advected vector; side: +1 right, -1 left.
/// @tparam Force  (time since the start of the step, velocity, vector, momentum) -> covector, energy
template <int side, class F, Real B, class Act, class Force = NoForce>
struct AdvectedGalerkinStep {
  static constexpr bool forced = !std::is_same_v<Force, NoForce>;
  F l;
  PolynomialPath<B> path;
  Act act;
  Force force = {};
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
        [&]<class R>(Matrix<R, Dynamic, 1> const& x) { return along(from, h, x).residual; }, evaluations);
    auto const done = along(from, h, xi);
    auto const f = exp(Velocity<G, S>{group, -xi.tail(group.dimension())});
    using Invariance = std::conditional_t<(side > 0), RightInvariant, LeftInvariant>;
    AdvectedMomentumStep<G, S, m> out{
        f,
        {Invariance::lie_poisson_update(f, done.mu), act(side > 0 ? inverse(f) : f, from.vector),
         velocity_at_end<side>(path, group, h, xi)},
        evaluations,
        done.work};
    if (forced) out.impulse = done.impulse;
    return out;
  }

 private:
  /// What a path gives.
  template <Group G, Scalar R>
  struct Along {
    Momentum<G, R> mu;               // at the start, less the torques along the path
    Momentum<G, R> impulse;          // of the force, transported to the start
    R work;                          // of the force
    Matrix<R, Dynamic, 1> residual;  // the numbers that vanish
  };
  template <Group G, Real S, int m, Scalar R>
  Along<G, R> along(AdvectedMomentumState<G, S, m> const& from, B const& h,
                    Matrix<R, Dynamic, 1> const& x) const {
    auto const mu = over<R>(from.momentum);
    Along<G, R> out{mu, R(0) * mu, R(0), {}};
    Matrix<R, m, 1> const a0 = from.vector.template cast<R>();
    // [advected_galerkin]
    auto const at_node = [&](int i, auto const& eta, Velocity<G, R> const& velocity) {
      Velocity<G, R> moved = velocity;
      for (Index k = 0; k < moved.coordinates.size(); ++k)
        moved.coordinates[k] = eta.coordinates[k].value * B(side);
      auto const g = exp(moved);  // of the path, as it acts on vectors
      Matrix<R, m, 1> const a = act(g, a0);
      auto torque = advected_differential(
          [&](auto const& k, auto const& vector) { return l(like(k, velocity), vector); },
          identity<R>(velocity.group), a, act);
      auto const p = gradient(holding(l, a), velocity);
      R const weight(h * path.weights[i]);
      if constexpr (forced) {
        auto const acting = force(h * path.nodes[i], velocity, a, p);
        torque = torque + R(B(side)) * acting;
        out.impulse = out.impulse + weight * Ad_star(g, acting);
        out.work += weight * pair(acting, velocity);
      }
      out.mu = out.mu + weight * R(B(side)) * Ad_star(g, torque);
      return AtNode<G, R>{p, R(h) * torque};
    };
    // [advected_galerkin]
    out.residual = galerkin_residual<side>(at_node, path, out.mu, h, x);
    return out;
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
/// The same of a left-invariant system with a force.
/// @param force  (time since the start of the step, velocity, vector, momentum) -> covector, energy
template <Real S, class F, class Act, class Force>
auto forced_galerkin_step_left(F l, int s, Act act, Force force) {
  return detail::AdvectedGalerkinStep<-1, F, S, Act, Force>{std::move(l), PolynomialPath<S>(s),
                                                            std::move(act), std::move(force)};
}
/// The same of a right-invariant system with a force.
template <Real S, class F, class Act, class Force>
auto forced_galerkin_step_right(F l, int s, Act act, Force force) {
  return detail::AdvectedGalerkinStep<1, F, S, Act, Force>{std::move(l), PolynomialPath<S>(s), std::move(act),
                                                           std::move(force)};
}
/// The same of a right-invariant system, with \f$a = g\,c\f$.
/// @param l  reduced Lagrangian, function of \f$\dot g g^{-1}\f$ and of a, energy
/// @param s  degree and number of nodes, 1 to 8
template <Real S, class F, class Act = MatrixAction>
auto advected_galerkin_step_right(F l, int s, Act act = {}) {
  return detail::AdvectedGalerkinStep<1, F, S, Act>{std::move(l), PolynomialPath<S>(s), std::move(act)};
}

}  // namespace actio
