// Translations of time and the current of energy (section 9.2 of the thesis).
#pragma once

#include "actio/jets/density.hpp"

namespace actio {

/// The field \f$(\zeta, 0, 0)\f$ on Y, with \f$\zeta = 1\f$: time runs on, body and space stay.
///
/// \implements{claim_9_2_time_invariance}
struct TimeTranslation {
  /// The field at a point (x, y) of Y.
  template <class V>
  auto operator()(V const&) const {
    using T = typename V::Scalar;
    Matrix<T, V::RowsAtCompileTime, 1> rate = Matrix<T, V::RowsAtCompileTime, 1>::Zero();
    rate[0] = T(1);
    return rate;
  }
};

/// The current of energy \f$e\,d^nx_0 + p_a{}^j\dot\phi^a\,d^nx_j\f$, the Noether current of
/// \ref TimeTranslation with the sign turned: energy density, then the energy that flows through the faces of
/// the body's coordinates.
///
/// \implements{claim_9_2_time_current}
/// @return  components, time first, per unit of \f$d^{n+1}x\f$: \f$\sqrt{\det G}\f$ is in them
/// @throws NoDerivative  where the density has none; and what the density refuses
template <class L, class S, int n, int N>
Event<S, n> energy_current(L const& density, Jet<S, n, N> const& j) {
  auto const p = momenta(density, j);
  Event<S, n> current;
  // [claim_9_2_time_current]
  current[0] = energy_density(density, j);
  for (int i = 1; i <= n; ++i) current[i] = p.col(i).dot(j.velocity());
  // [claim_9_2_time_current]
  return current;
}

}  // namespace actio
