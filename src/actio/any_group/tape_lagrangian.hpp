// A Lagrangian given as a formula, as a callable on velocities and vectors: what the generic implementation
// takes.
#pragma once

#include <memory>

#include "actio/any_group/reduced_system.hpp"
#include "actio/any_group/span_of_matrices.hpp"
#include "actio/groups/group.hpp"

namespace actio::systems {

/// l(v, a) of a system, at every scalar. A copy has its own work space for each call.
struct TapeLagrangian {
  std::shared_ptr<ReducedSystem const> system;  ///< whose Lagrangian it is

  /// Energy, at a velocity of a group with the coordinates of the system, without vectors.
  template <Group G, Scalar S>
  S operator()(Velocity<G, S> const& v) const { return (*this)(v, Matrix<S, Dynamic, 1>(0)); }
  /// The same with the carried vectors, one after the other.
  template <Group G, Scalar S>
  S operator()(Velocity<G, S> const& v, Matrix<S, Dynamic, 1> const& a) const {
    thread_local std::vector<S> work;
    S value(0);
    std::vector<S> inputs(v.coordinates.data(), v.coordinates.data() + v.coordinates.size());
    inputs.insert(inputs.end(), a.data(), a.data() + a.size());
    system->lagrangian(inputs.data(), &value, work);
    return value;
  }
};

/// The same with its vectors held fixed. Its differentials are formulas, too.
struct HeldTape {
  ReducedSystem const& system;             ///< whose Lagrangian it is
  Matrix<double, Dynamic, 1> const& held;  ///< the vectors, one after the other

  /// The values of one of the tapes of the system at a velocity.
  std::vector<double> const& values(Tape const& tape, Coordinates<SpanOfMatrices, double> const& v) const;
};

/// A tape with vectors that outlive what is returned.
inline HeldTape holding(TapeLagrangian const& l, Matrix<double, Dynamic, 1> const& a) {
  return {*l.system, a};
}
/// The momentum of a velocity.
/// @throws NotFinite  where the Lagrangian or its differential is no number
Momentum<SpanOfMatrices, double> gradient(HeldTape const& l, Velocity<SpanOfMatrices, double> const& v);
/// \f$\partial^2l/\partial v^2\f$.
/// @throws NotFinite  where an entry is no number
Matrix<double> hessian(HeldTape const& l, Velocity<SpanOfMatrices, double> const& v);
/// \f$\partial l/\partial a\f$.
/// @throws NotFinite  where it is no number
Matrix<double, Dynamic, 1> slope_in_vector(TapeLagrangian const& l, Velocity<SpanOfMatrices, double> const& v,
                                           Matrix<double, Dynamic, 1> const& a);

}  // namespace actio::systems
