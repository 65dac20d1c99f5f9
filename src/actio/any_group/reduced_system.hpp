// An invariant system on a group of matrices, given at run time: an algebra, a side, and a Lagrangian as a
// formula.
//
// The Lagrangian is a function l(v, a) of the velocity, v = g^-1 g' (left-invariant) or g' g^-1
// (right-invariant), and of vectors that the motion carries: a = g^-1 c or a = g c with c fixed. Its momentum
// p = dl/dv obeys
//
//     p' = +- (ad*_v p - J),      <J, eta> = dl/da . (eta a),      a' = -+ v a,
//
// the upper signs on the left, and a force F is added to p' on either side. One number, `sign`, tells the
// sides apart: a right-invariant system is a left-invariant one with all brackets turned round.
#pragma once

#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

#include "actio/any_group/dissipation.hpp"
#include "actio/any_group/generalized_force.hpp"
#include "actio/any_group/matrix_algebra.hpp"
#include "actio/formula/tape_derivatives.hpp"
#include "actio/numbers/derivative.hpp"

namespace actio::systems {

/// On which side translations leave a Lagrangian as it is.
enum class Side {
  left,  ///< velocities and momenta are those of the body
  right  ///< velocities and momenta are those in space
};

/// How a velocity moves the group over a step: the chart in which the two configurations are subtracted.
enum class Chart {
  exponential,  ///< by exp(h v), the natural chart
  cayley        ///< by Cayley's transform of h v, where that maps into the group
};

/// An invariant system on a group of matrices.
struct ReducedSystem {
  MatrixAlgebra algebra;  ///< of the group
  Side side;              ///< of the invariance
  Chart chart;            ///< of its steps
  int vectors;            ///< how many are carried, each as long as the matrices have rows
  Tape lagrangian;        ///< l(v, a): the velocity, then the vectors one after the other; energy
  Tape slopes;            ///< l, then its differential in v and in a
  Tape curvature;         ///< l, its differential in v, the upper triangle of the second one row by row
  std::optional<GeneralizedForce> force = {};   ///< on the system, if any
  std::optional<Dissipation> dissipation = {};  ///< of the system, if any

  /// @param l  of as many inputs as the algebra has dimensions and the vectors have components
  /// @throws OutsideDomain  where it has another number of inputs
  ReducedSystem(MatrixAlgebra of, Side invariant, int carried_vectors, Tape l,
                Chart of_steps = Chart::exponential);

  int dimension() const { return algebra.dimension; }       ///< of the group
  int length() const { return algebra.size; }               ///< of a vector
  int carried() const { return vectors * algebra.size; }    ///< numbers in all vectors
  int sign() const { return side == Side::left ? 1 : -1; }  ///< of the bracket
};

}  // namespace actio::systems
