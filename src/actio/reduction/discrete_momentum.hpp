// Discrete momentum maps: what a symmetry of the discrete Lagrangian conserves, exactly and at every step
// length.
#pragma once

#include "actio/reduction/discrete_forms.hpp"

namespace actio {

/// \f$J_\xi(g_0, g_1) = \xi_{G\times G}\lrcorner\theta^+_L = \langle D_2 L(g_0, g_1),
/// \vartheta(g_1)\rangle\f$.
///
/// \implements{eq_3_8}
/// @param generator  Element at any scalar -> Velocity at the same: the generator on G, translated to the
///   identity on the right
template <Group G, Scalar S, class L, class Generator>
S discrete_momentum(L const& lagrangian, Element<G, S> const& g0, Element<G, S> const& g1,
                    Generator const& generator) {
  // [eq_3_8]
  return pair(D2(lagrangian, g0, g1), generator(g1));
  // [eq_3_8]
}

}  // namespace actio
