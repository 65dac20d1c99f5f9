// Curves in a group, their tangents, and their variations.
//
// A curve is any callable from a time to an element, a family of curves any callable from (epsilon, time), at
// every scalar. Tangents and variations come from evaluating them on dual numbers: nothing is subtracted, no
// step is small.
#pragma once

#include "actio/variational/state.hpp"

namespace actio {

/// The element at the bottom of one that moves.
template <Group G, Scalar S>
Element<G, S> value_of(Element<G, Dual<S>> const& g) {
  return {g.group, g.value.unaryExpr([](Dual<S> const& x) { return x.value; })};
}
/// The velocity at the bottom of one that changes.
template <Group G, Scalar S>
Velocity<G, S> value_of(Velocity<G, Dual<S>> const& xi) {
  return {xi.group, xi.coordinates.unaryExpr([](Dual<S> const& x) { return x.value; })};
}
/// The state at the bottom of one that moves.
template <Group G, Scalar S>
State<G, S> value_of(State<G, Dual<S>> const& v) { return {value_of(v.configuration), value_of(v.velocity)}; }

/// How an element moves, translated to the identity on the right: \f$\dot g\,g^{-1}\f$.
template <MatrixGroup G, Scalar S>
Velocity<G, S> rate_right(Element<G, Dual<S>> const& g) {
  Storage<G, S> const rate = g.value.unaryExpr([](Dual<S> const& x) { return x.part[0]; });
  return {g.group, g.group.vee(Storage<G, S>(rate * inverse(value_of(g)).value))};
}
/// How a velocity changes.
template <Group G, Scalar S>
Velocity<G, S> rate_of(Velocity<G, Dual<S>> const& xi) {
  return {xi.group, xi.coordinates.unaryExpr([](Dual<S> const& x) { return x.part[0]; })};
}
/// How a momentum changes.
template <Group G, Scalar S>
Momentum<G, S> rate_of(Momentum<G, Dual<S>> const& mu) {
  return {mu.group, mu.components.unaryExpr([](Dual<S> const& x) { return x.part[0]; })};
}
/// How a state moves, as a tangent vector to TG: undoes \ref moved.
template <MatrixGroup G, Scalar S>
StateChange<G, S> change_of(State<G, Dual<S>> const& v) {
  return {rate_right(v.configuration), rate_of(v.velocity)};
}

/// The tangent \f$(g, \dot g g^{-1})\f$ of a curve, a point of TG.
template <Scalar S, class Curve>
auto tangent(Curve const& curve, S const& t) {
  auto const g = curve(variable(t));
  auto const configuration = value_of(g);
  return State<typename std::decay_t<decltype(configuration)>::GroupType, S>{configuration, rate_right(g)};
}
/// \f$\ddot g\f$: the tangent vector to TG of the curve of tangents. Its configuration part is the velocity
/// again, which is what makes it second order; its velocity part is \f$\dot\xi\f$.
///
/// \implements{claim_2_1_second_order_set}
template <Scalar S, class Curve>
auto second_tangent(Curve const& curve, S const& t) { return change_of(tangent(curve, variable(t))); }

/// The tangents of a family of curves at time t, moved infinitely little by epsilon.
template <Scalar S, class Family>
auto varied_tangent(Family const& family, S const& t) {
  Dual<S> const epsilon = variable(S(0));
  return tangent([&](auto const& s) { return family(std::decay_t<decltype(s)>(epsilon), s); }, Dual<S>(t));
}
/// \f$\hat\delta g(t)\f$: the variation of a curve lifted to TG, taken at the same time t as the variation
/// itself.
///
/// \implements{claim_2_1_lifted_variation}
template <Scalar S, class Family>
auto lifted_variation(Family const& family, S const& t) {
  // [claim_2_1_lifted_variation]
  return change_of(varied_tangent(family, t));
  // [claim_2_1_lifted_variation]
}

}  // namespace actio
