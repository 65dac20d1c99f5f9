// Coadjoint orbits and their symplectic forms.
//
// The orbit of mu lies in the dual of the algebra: the set of all Ad*_{g^-1} mu. Its tangent vectors at mu
// are the ad*_eta mu.
#pragma once

#include <vector>

#include "actio/groups/differential.hpp"

namespace actio {

/// A velocity \f$\eta\f$ with \f$\mathrm{ad}^*_\eta\,\mu = w\f$: how the coadjoint action produces a tangent
/// vector of an orbit.
///
/// It is unique up to the isotropy algebra of \f$\mu\f$.
/// @param w  tangent to the orbit at mu
/// @throws OutsideDomain  where w is not tangent to the orbit: with the residual, against rounding
template <Group G, Scalar S>
Velocity<G, S> orbit_generator(Momentum<G, S> const& mu, Momentum<G, S> const& w) {
  int const n = mu.group.dimension();
  Matrix<S, Dynamic, Dynamic> a(n, n);
  for (int c = 0; c < n; ++c) a.col(c) = ad_star(basis_velocity<S>(mu.group, c), mu).components;
  Matrix<S, Dynamic, 1> b = w.components;
  Base<S> const scale = magnitude(a), tiny = Base<S>(256 * n) * epsilon<S>();

  // Eliminate with full pivoting until the remaining block is at rounding.
  std::vector<int> column(n);
  for (int c = 0; c < n; ++c) column[c] = c;
  int rank = 0;
  for (; rank < n; ++rank) {
    int row = rank, best = rank;
    for (int i = rank; i < n; ++i)
      for (int c = rank; c < n; ++c)
        if (magnitude(base_value(a(i, c))) > magnitude(base_value(a(row, best)))) row = i, best = c;
    if (!(magnitude(base_value(a(row, best))) > tiny * scale)) break;
    a.row(rank).swap(a.row(row)), a.col(rank).swap(a.col(best));
    std::swap(b[rank], b[row]), std::swap(column[rank], column[best]);
    for (int i = rank + 1; i < n; ++i) {
      S const factor = a(i, rank) / a(rank, rank);
      for (int c = rank; c < n; ++c) a(i, c) -= factor * a(rank, c);
      b[i] -= factor * b[rank];
    }
  }
  Base<S> left(0);
  for (int i = rank; i < n; ++i)
    if (magnitude(b[i]) > left) left = magnitude(b[i]);
  Base<S> const allowed = Base<S>(16) * tiny * magnitude(w.components);
  if (left > allowed)
    throw OutsideDomain("orbit_generator", "a tangent vector of the coadjoint orbit is needed; part outside",
                        to_double(left), to_double(allowed));

  Velocity<G, S> eta{mu.group, Coordinates<G, S>::Zero(n)};
  for (int i = rank - 1; i >= 0; --i) {
    S sum = b[i];
    for (int c = i + 1; c < rank; ++c) sum -= a(i, c) * eta.coordinates[column[c]];
    eta.coordinates[column[i]] = sum / a(i, i);
  }
  return eta;
}

/// The Kirillov-Kostant form \f$\omega_+\f$ on two tangent vectors of the orbit of mu:
/// \f[ \omega_+(\mu)(\mathrm{ad}^*_\xi\mu, \mathrm{ad}^*_\eta\mu) = \langle\mu, [\xi, \eta]\rangle . \f]
///
/// \implements{claim_2_2_coadjoint_action_kk}
/// @throws OutsideDomain  where a vector is not tangent to the orbit
template <Group G, Scalar S>
S kirillov_kostant_plus(Momentum<G, S> const& mu, Momentum<G, S> const& v, Momentum<G, S> const& w) {
  // [claim_2_2_coadjoint_action_kk]
  return pair(mu, bracket(orbit_generator(mu, v), orbit_generator(mu, w)));
  // [claim_2_2_coadjoint_action_kk]
}
/// \f$\omega_- = -\omega_+\f$, the form that belongs to the minus bracket.
template <Group G, Scalar S>
S kirillov_kostant_minus(Momentum<G, S> const& mu, Momentum<G, S> const& v, Momentum<G, S> const& w) {
  return -kirillov_kostant_plus(mu, v, w);
}

}  // namespace actio
