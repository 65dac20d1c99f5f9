// What a group of matrices does to Euclidean space, as far as its algebra tells: whether it only turns it,
// or turns and shifts it, and whether its coadjoint orbits lie on spheres.
#pragma once

#include "actio/any_group/matrix_algebra.hpp"

namespace actio::systems {

/// Whether every matrix of the algebra is skew: elements of the group near the identity are rotations.
inline bool is_of_rotations(MatrixAlgebra const& algebra) {
  for (auto const& e : algebra.basis)
    if (e != -e.transpose()) return false;
  return true;
}

/// Whether every matrix is ((A, v), (0, 0)) with A skew: elements near the identity turn and shift a space of
/// one dimension less than the matrices have rows.
bool is_of_rigid_motions(MatrixAlgebra const& algebra);

/// Whether the coadjoint action preserves the length \f$\sum_a\mu_a^2\f$ of a momentum, and moves some:
/// structure constants change their sign when any two of their indices are exchanged, and are not all zero.
/// True of SO(n) and SU(2), in the bases of the library.
bool keeps_length_of_momenta(MatrixAlgebra const& algebra);

}  // namespace actio::systems
