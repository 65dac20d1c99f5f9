// Runs of the Moser-Veselov scheme beside the flow of the body: what its three forms approach, and at which
// rate, as the step goes to zero.
#pragma once

#include "actio/rigid_body/moser_veselov.hpp"
#include "models/body_flow.hpp"
#include "models/generalized_bodies.hpp"

namespace actio::checks {

template <class S>
using Scheme = MoserVeselov<Dynamic, S>;

/// A free body in its principal frame, where it is at the beginning, and at the end of a ladder of steps.
template <class S>
struct MovingBody {
  Matrix<S> lambda;
  Inertia<Dynamic, S> inertia;
  BodyFlow<S> flow;
  BodyState<S> start;

  int n() const { return inertia.group.n; }
  Turns const& group() const { return inertia.group; }
  Scheme<S> scheme(S const& h) const { return Scheme<S>(inertia, h); }
  BodyMomentum<S> first_momentum() const { return {group(), start.momentum}; }
  BodyState<S> end() const { return flow(start, S(in_half_a_unit.duration), 8); }
  /// Where it is, and where it was, a time h from the beginning.
  Turn<S> exact(S const& h) const { return {group(), flow(start, h, 1).attitude}; }
};
template <class S>
MovingBody<S> draw_moving_body(Draw& draw, int n) {
  Matrix<S> const lambda = draw_inertia<S>(draw, n);
  auto const inertia = inertia_from_lambda<Dynamic, S>(Vector<S>(lambda.diagonal()));
  BodyFlow<S> const flow(inertia.group, Matrix<S>(inertia.moments.asDiagonal()));
  Vector<S> const momentum = inertia.moments.cwiseProduct(draw_turning<S>(draw, n).coordinates);
  BodyState<S> const start{momentum, draw_turn<S>(draw, n).value};
  return {lambda, inertia, flow, start};
}

/// Errors of an algorithm on the group alone: from two attitudes of the body itself, the first a
/// step before the beginning, by `next(scheme, f)`.
template <class S, class Next>
BodyErrors errors_on_the_group(MovingBody<S> const& body, Next const& next) {
  return errors_against(body.end(), in_half_a_unit, [&](int count, S const& h) {
    auto const scheme = body.scheme(h);
    Turn<S> g{body.group(), body.start.attitude}, f = relative_motion_left(body.exact(S(-h)), g);
    for (int k = 0; k < count; ++k) f = next(scheme, f), g = g * inverse(f);
    return BodyState<S>{body.group().vee(after(body.lambda, f)) / h, g.value};
  });
}
/// Errors of an algorithm of momenta: `next(scheme, M, f)` makes of the momentum before a step that before
/// the next one, f being the relative motion that M asks for.
template <class S, class Next>
BodyErrors errors_of_momenta(MovingBody<S> const& body, Next const& next) {
  return errors_against(body.end(), in_half_a_unit, [&](int count, S const& h) {
    auto const scheme = body.scheme(h);
    BodyMomentum<S> m = body.first_momentum();
    Turn<S> g{body.group(), body.start.attitude}, f = identity<S>(body.group());
    for (int k = 0; k < count; ++k) {
      f = scheme.relative_motion(m).value;
      g = g * inverse(f), m = next(h, m, f);
    }
    return BodyState<S>{m.components, g.value};
  });
}

}  // namespace actio::checks
