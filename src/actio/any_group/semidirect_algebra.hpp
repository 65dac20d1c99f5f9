// The algebra of a group together with the vectors that its motion carries.
#pragma once

#include "actio/any_group/matrix_algebra.hpp"

namespace actio::systems {

/// The algebra of G together with covectors that it acts on: in its dual moves the pair of a momentum and the
/// vectors that the motion carries.
///
/// With \f$\xi\cdot w = -\xi^Tw\f$ the bracket is \f$[(\xi, w), (\eta, u)] = ([\xi, \eta],\ \xi\cdot u -
/// \eta\cdot w)\f$, so that \f$(\dot\mu, \dot a) = \mathrm{ad}^*_{(\xi, w)}(\mu, a)\f$ has
/// \f$\dot a = -\xi a\f$: left-invariant systems with \f$a = g^{-1}c\f$. The opposite sign of the bracket is
/// that of right-invariant ones, \f$a = g\,c\f$. Coordinates: those of G, then the vectors one after the
/// other.
///
/// @param vectors  how many are carried, at least one
/// @param length   of each; matrices act on columns as long as they have rows
/// @param names    of the vectors; `a` gives the components `a1`, `a2`, ... Without names a single vector is
///                 `a`, several are `a1_`, `a2_`, ...
/// @throws OutsideDomain  where the length is another one, or where the vectors have more than 128 components
MatrixAlgebra semidirect_algebra(MatrixAlgebra const& group, int vectors, int length,
                                 std::vector<std::string> const& names = {});

}  // namespace actio::systems
