// The symmetry that remains where a vector is advected, and what it conserves: the momentum of the stabiliser
// of the vector.
#pragma once

#include <cmath>

#include "actio/groups/differential.hpp"
#include "actio/reduction/advected.hpp"

namespace actio {

/// \f$\zeta\,a = \frac{d}{d\epsilon}e^{\epsilon\zeta}a\f$: how an element of the algebra moves a vector.
template <Group G, Scalar S, int m, class Act = MatrixAction>
  requires ActsOn<Act, G, S, m>
Matrix<S, m, 1> moved_by(Velocity<G, S> const& zeta, Matrix<S, m, 1> const& a, Act const& act = {}) {
  Matrix<S, m, 1> rate = Matrix<S, m, 1>::Zero(a.size());
  over_batches(zeta.group.dimension(), [&](int first) {
    Matrix<Moved<S>, m, 1> const moved =
        act(moved_left(identity<S>(zeta.group), first), Matrix<Moved<S>, m, 1>(a.template cast<Moved<S>>()));
    for (Index i = 0; i < a.size(); ++i)
      for (int b = 0; b < batch && first + b < zeta.group.dimension(); ++b)
        rate[i] += moved[i].part[b] * zeta.coordinates[first + b];
  });
  return rate;
}

/// \f$\langle\Pi, \zeta\rangle\f$ with \f$\zeta a = 0\f$: the momentum of the remaining symmetry, the
/// stabilizer of the vector a. The same at both ends of every step.
///
/// The generator is transported as the vector is: \f$\zeta_1 = \mathrm{Ad}_f\,\zeta_0\f$ for a left-invariant
/// system, \f$\mathrm{Ad}_{f^{-1}}\zeta_0\f$ for a right-invariant one. For SO(3) on 3-space
/// \f$\zeta = a\f$, which makes it \f$\langle\Pi, a\rangle\f$, the momentum about the vertical.
/// @throws OutsideDomain  where \f$\zeta a\f$ is not zero, so that nothing is conserved: its size over that
///                        of \f$\zeta\f$ times a, and the bound. Over the rationals it must be 0; elsewhere
///                        half of the digits are enough, since rounding may have moved generator and vector
///                        for long.
template <Group G, Scalar S, int m, class Act = MatrixAction>
S stabiliser_momentum(Momentum<G, S> const& pi, Velocity<G, S> const& zeta, Matrix<S, m, 1> const& a,
                      Act const& act = {}) {
  auto const size = magnitude(zeta.coordinates) * magnitude(a);
  double const measured =
      size > Base<S>(0) ? to_double(Base<S>(magnitude(moved_by(zeta, a, act)) / size)) : 0.0;
  double const bound = std::sqrt(to_double(epsilon<S>()));
  if (!(measured <= bound))
    throw OutsideDomain("stabiliser_momentum",
                        "a generator that fixes the vector is needed; size of what it does to it", measured,
                        bound);
  return pair(pi, zeta);
}

}  // namespace actio
