// One step of the discrete principle of Lagrange and d'Alembert, in the natural chart.
//
// The velocity v of a step, and the multipliers at its start, solve
//
//     P_0(v) = mu + A(a_0, t_0)^T lambda,      c(v, a_1/2, t_1/2) = 0,      a_1/2 = exp(-hv/2) a_0,
//
// with the momenta P_0, P_1 at the ends of the step (actio/any_group/chart_step.hpp), mu = P_1 of the step
// before. Variations at a node obey A there; so do the reactions. The constraint in the middle makes the step
// self-adjoint: order 2, and compositions have higher ones. With the constraint at the start or at the end of
// the step the order is 1.
//
// Reactions that act along the rows at the nodes change no momentum that the rows annihilate there: that of a
// ball about its point of contact obeys the free step. It is the nonholonomic momentum equation, exactly.
//
// In Cayley's chart a_1/2 is the mean of the vectors at both ends.
#pragma once

#include "actio/any_group/chart_step.hpp"
#include "actio/nonholonomic/velocity_constraints.hpp"

namespace actio::systems {

/// Momenta at both ends of a step and the constraints in its middle, at one scalar, with their work space.
template <class S>
class RattleStep {
 public:
  /// Of a system and constraints that outlive it.
  RattleStep(ReducedSystem const& system, VelocityConstraints const& constraints)
      : momenta(system), middle(constraints) {
    momenta.halfway = momenta.vectors;
  }

  ChartStep<S> momenta;        ///< at both ends
  ConstraintValues<S> middle;  ///< the constraints in the middle of the step

  /// @param h  step, time
  /// @param t  time at the start
  /// @param v  velocity of the step
  /// @param a  vectors at the start
  /// @return   false where the step leaves the chart
  bool operator()(S const& h, S const& t, std::vector<S> const& v, std::vector<S> const& a) {
    momenta.begin_at(t);
    if (!momenta(h, v, a)) return false;
    middle.set_values(v, momenta.halfway, t + h / S(2));
    return true;
  }
};

}  // namespace actio::systems
