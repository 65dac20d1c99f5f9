// Runs of systems with constraints on their velocity: momenta, carried vectors, reactions, and configurations
// and what forces and reactions have done where they are asked for.
#pragma once

#include <Eigen/Core>

#include <memory>

#include "actio/any_group/chart_integrator.hpp"
#include "actio/nonholonomic/constrained_solver.hpp"

namespace actio::systems {

/// A state that obeys constraints.
struct ConstrainedState {
  ReducedPoint point;            ///< momentum and vectors
  std::vector<double> velocity;  ///< \f$\partial l/\partial v\f$ of it is the momentum
  double moved;                  ///< how far the velocity that was given broke the constraints, relative
};

/// The state with a velocity, moved on the constraints as a blow does that makes a body roll.
///
/// @param v        velocity, 1/time
/// @param a        vectors
/// @param t        time
/// @param allowed  how far the velocity may break a constraint, relative to what that is of a velocity of
///                 this size
/// @throws OutsideDomain  where it is further off
/// @throws Singular       where rows depend on each other, with the number of the row
/// @throws NotFinite      where a number is none, or a formula has no value there
ConstrainedState constrained_state(ReducedSystem const& system, VelocityConstraints const& constraints,
                                   std::vector<double> const& v, std::vector<double> const& a, double t = 0,
                                   double allowed = 1e-6);

/// Thrown where rows turn too far in a step: it is too long for them, or they have no limit there, as at the
/// contact of a disc that lies flat.
struct RowsTurn : OutsideDomain {
  /// @param number   of the constraint, from 1
  /// @param radians  by which its row turns, in the metric of the Lagrangian
  RowsTurn(std::size_t number, double radians);
  static constexpr double most = 1;  ///< radian
};

/// Steps of one length, each of some substeps. For one thread at a time. Damping in proportion to the
/// momentum acts for half of a substep before and after it: by a factor of the momentum, which is known up to
/// a combination of the rows.
///
/// \snippet nonholonomic.cpp rattle_integrator
/// @tparam Step  \ref RattleStep, or \ref ConservingStep
template <template <class> class Step>
class ConstrainedIntegrator {
 public:
  /// @param system       of which the run is
  /// @param constraints  of its velocity
  /// @param h            step, time
  /// @param fractions    of the substeps (composition.hpp); {1} for order 2, five of `suzuki()` for order 4
  /// @param start        obeys the constraints
  /// @param t            time at the start
  /// @throws OutsideDomain  where such steps cannot take the system, or its friction is on the orbit
  ConstrainedIntegrator(std::shared_ptr<ReducedSystem const> system,
                        std::shared_ptr<VelocityConstraints const> constraints, double h,
                        std::vector<double> const& fractions, ConstrainedState const& start, double t = 0);

  /// Reconstructs configurations from this one on.
  void follow_configuration(Eigen::MatrixXd g) { now_.configuration = std::move(g); }
  /// Sums up what forces and reactions do. Their impulse goes with the configuration, and with steps whose
  /// reactions act at the nodes: elsewhere it stays empty.
  /// @param before  what they have done already
  void follow_ledger(ForceLedger before = {});

  /// A whole step.
  /// @throws NotConverged, Singular, NotFinite  where a substep has no solution; all is then as it was
  /// @throws RowsTurn                           where the row of a constraint turns by more than a radian in
  ///                                            a substep; likewise
  void step();

  double time() const { return start_ + static_cast<double>(steps_) * h_; }  ///< now
  /// Momentum before the reactions of the next step, up to a combination of the rows; and vectors.
  ReducedPoint const& point() const { return now_.point; }
  /// By rattle momentum and velocity that obey the constraints, and vectors. Where the energy is conserved
  /// they are those that have the energy: not they obey the constraints, but the velocity of each step.
  /// @throws NotConverged, Singular, NotFinite  where the Lagrangian is not regular along the constraints
  ConstrainedState state() const;
  /// The values of the constraints: at the state, or in the middle of the last substep where the energy is
  /// conserved.
  std::vector<double> constraint() const;
  /// The reactions, force along each row: as accurate as the state.
  std::vector<double> reaction() const;
  /// What forces and reactions have done up to the state; nothing where it is not followed. By rattle its
  /// impulse explains the momentum of the symmetry to rounding; where the energy is conserved its work
  /// explains the energy to rounding.
  ForceLedger ledger() const;
  /// empty where it is not followed
  Eigen::MatrixXd const& configuration() const { return now_.configuration; }
  /// of the last substep
  std::vector<double> velocity_of_substep() const { return substeps_.back().velocity(); }
  /// The multipliers of the last substep. By rattle the impulse of the reactions at its start, half of it
  /// from the substep before.
  std::vector<double> impulse() const { return substeps_.back().multipliers(); }
  /// How often momenta were evaluated.
  long evaluations() const {
    long sum = 0;
    for (auto const& substep : substeps_) sum += substep.evaluations();
    return sum;
  }

  /// Saves, or restores, all that the next step depends on.
  template <class Stream>
  void remember(Stream& stream) {
    stream(start_, steps_, now_.point.momentum, now_.point.vectors, now_.rows, now_.middle, now_.ledger.work,
           now_.ledger.impulse);
    std::span<double> g(now_.configuration.data(), static_cast<std::size_t>(now_.configuration.size()));
    stream(g);
    for (auto& substep : substeps_) substep.remember(stream);
  }

 private:
  static constexpr bool at_nodes_ = std::is_same_v<Step<double>, RattleStep<double>>;  // the reactions
  using Solver = ConstrainedSolver<Step>;

  void take(Solver& substep, double t);
  /// Refuses rows that turn too far from the last node to vectors at a time.
  void turn_rows(std::vector<double> const& vectors, double t);
  /// The same for where the velocity now leads in a step that has no solution.
  void look_ahead(double h, double t);
  /// The work and the impulse of reactions at a node.
  void add_reactions(ForceLedger& ledger, ReducedPoint const& at, double t,
                     std::vector<double> const& multipliers) const;
  void add_impulse(ForceLedger& ledger, double times, std::vector<double> const& covector) const;
  /// The state on the constraints, and the multipliers that move the momentum there.
  std::pair<ConstrainedState, std::vector<double>> projected() const;

  /// What a step changes.
  struct Now {
    ReducedPoint point = {};
    Eigen::MatrixXd configuration = {};
    std::vector<double> rows = {},  // at the last node
        middle = {};                // the values of the constraints
    ForceLedger ledger = {};
  };

  std::shared_ptr<ReducedSystem const> system_;
  std::shared_ptr<VelocityConstraints const> constraints_;
  std::vector<Solver> substeps_;
  double h_, start_;
  long steps_ = 0;
  Now now_, before_;
  ConstraintValues<double> nodes_;
  std::vector<double> units_;
  bool rows_turn_ = false, with_ledger_ = false;
};

extern template class ConstrainedIntegrator<RattleStep>;
extern template class ConstrainedIntegrator<ConservingStep>;
using RattleIntegrator = ConstrainedIntegrator<RattleStep>;          ///< by the discrete principle
using ConservingIntegrator = ConstrainedIntegrator<ConservingStep>;  ///< conserving the energy

}  // namespace actio::systems
