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

#include <cmath>

#include "actio/any_group/chart_solver.hpp"
#include "actio/nonholonomic/velocity_constraints.hpp"

namespace actio::systems {

/// The equations of one such step at one scalar, with their work space.
template <class S>
class RattleStep {
 public:
  static constexpr char const* name = "rattle";  ///< in messages
  static constexpr double share = 1;             ///< of the reactions, which comes before the middle
  /// It takes every system.
  static void require(ReducedSystem const&) {}

  /// Of a system and constraints that outlive it.
  RattleStep(ReducedSystem const& system, VelocityConstraints const& constraints)
      : constraint(constraints), momenta(system), system_(system) {
    momenta.halfway = momenta.vectors;
  }

  ConstraintValues<S> constraint;  ///< values in the middle of the step, rows at its start
  ChartStep<S> momenta;            ///< at both ends

  /// Sets the rows at the vectors and the time of the start.
  void begin(std::vector<S> const& a, S const& t) { constraint.set_rows(a, t); }

  /// @param h  step, time
  /// @param t  time at the start
  /// @param v  velocity of the step
  /// @param a  vectors at the start
  /// @return   false where the step leaves the chart
  bool operator()(S const& h, S const& t, std::vector<S> const& v, std::vector<S> const& a) {
    momenta.begin_at(t);
    if (!momenta(h, v, a)) return false;
    constraint.set_values(v, momenta.halfway, t + h / S(2));
    return true;
  }

  /// The momentum at the start with the share of the reactions.
  std::vector<S> const& before() const { return momenta.before; }
  std::vector<S> const& vectors_at_end() const { return momenta.vectors; }  ///< that are carried
  /// The size of what a component of it is a sum of.
  double size(std::size_t i) const { return std::abs(momenta.before[i]) + momenta.sizes[i]; }
  /// Takes the point to the end of the step. What the last residual leaves of the momentum goes with the step
  /// as the momentum does.
  /// @param x  velocity and multipliers
  /// @throws OutsideDomain  where the step turns by half a turn or more; the point is as it was
  void finish(double h, std::vector<double> const& x, std::vector<double> const& residual,
              ReducedPoint& point) {
    auto const d = point.momentum.size();
    require_in_chart(system_, momenta, h, {x.begin(), x.begin() + static_cast<std::ptrdiff_t>(d)});
    left_.assign(residual.begin(), residual.begin() + static_cast<std::ptrdiff_t>(d));
    momenta.transport(left_);
    for (std::size_t i = 0; i < d; ++i) point.momentum[i] = momenta.after[i] - left_[i];
    point.vectors = momenta.vectors;
  }

 private:
  ReducedSystem const& system_;
  std::vector<S> left_;
};

}  // namespace actio::systems
