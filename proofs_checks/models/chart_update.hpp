// The natural-chart scheme of the rigid body as (5.4) writes it, iterated as it stands, beside the flow of
// the body.
#pragma once

#include "models/body_flow.hpp"
#include "models/chart_models.hpp"

namespace actio::checks {

/// A matrix applied to a momentum, and its dual.
template <class S>
Vector<S> dual_of(Matrix<S> const& m, Vector<S> const& mu) { return m.transpose() * mu; }

/// The right side of (5.4) with signs and operators to choose: as printed, all three are minus.
template <class S>
struct ChartUpdate {
  SpannedGroup group;
  Matrix<S> j, inverse_of_j;
  S h;
  int in_iex = -1, in_chi = -1;  ///< the sign of the argument of iex; with chi of (3.26) that of its iex
  int in_Ad = -1;                ///< the sign in the exponential
  int direction = -1;            ///< zeta is so many times the velocity

  Matrix<S> iex_of(Algebra<S> const& zeta) const { return iex(ad_matrix(h * zeta)); }
  /// What iex is applied to: the body momentum after a step, times `direction`.
  Vector<S> momentum_after(Algebra<S> const& zeta) const {
    auto const turned = Ad_star(exp(S(in_Ad) * h * zeta), momentum(group, Vector<S>(j * zeta.coordinates)));
    return dual_of(Matrix<S>(inverse_matrix(iex_of(S(in_chi) * zeta))), Vector<S>(turned.components));
  }
  /// The next zeta: (5.4) is a map with that fixed point, which contracts where the step is short.
  Algebra<S> next(Algebra<S> const& earlier) const {
    Vector<S> const carried = momentum_after(earlier);
    Algebra<S> later = earlier;
    for (int sweep = 0; sweep < 40; ++sweep) {
      Algebra<S> const better{group, inverse_of_j * dual_of(iex_of(S(in_iex) * later), carried)};
      bool const done = size_of(better - later) <= S(4) * epsilon<S>() * size_of(earlier);
      later = better;
      if (done) break;
    }
    return later;
  }
};
/// How far (5.4) is from the flow of the body after half a unit of time, from two attitudes of the body
/// itself, the first a step before the beginning. The velocity of the last step is that half-way; the flow
/// carries it on to the end.
template <class S>
BodyErrors errors_of_chart_update(BodyFlow<S> const& flow, BodyState<S> const& start, ChartUpdate<S> update) {
  BodyState<S> const end = flow(start, S(in_half_a_unit.duration), 4);
  return errors_against(end, in_half_a_unit, [&](int count, S const& h) {
    update.h = h;
    GroupElement<S> const before{update.group, flow(start, -h, 1).attitude};
    GroupElement<S> g{update.group, start.attitude};
    S const sign(update.direction);
    Algebra<S> zeta = sign * log(inverse(before) * g) / h;
    for (int k = 0; k < count; ++k) {
      zeta = update.next(zeta);
      g = g * exp(sign * h * zeta);
    }
    Vector<S> const half_way = update.j * (sign * zeta).coordinates;
    return BodyState<S>{flow({half_way, Matrix<S>(0, 0)}, h / S(2), 1).momentum, g.value};
  });
}

}  // namespace actio::checks
