// Motions by the discrete Euler-Lagrange equations on G x G, step after step.
#pragma once

#include "actio/groups/predictor_corrector.hpp"
#include "actio/reduction/discrete_euler_lagrange.hpp"

namespace actio {

/// The motion of a discrete Lagrangian on \f$G\times G\f$: \ref discrete_euler_lagrange solved step after
/// step.
///
/// Configurations are those of \ref step_euler_lagrange to rounding, in a fraction of the time: the
/// derivative of the equation is reused from step to step, and the next configuration is extrapolated from
/// the last ones (\ref PredictorCorrector).
///
/// \snippet reduction.cpp euler_lagrange_steps
/// @tparam L  discrete Lagrangian, \f$G\times G\to\mathbb R\f$, energy x time
template <class L, ExponentialGroup G, Real S>
class EulerLagrangeSteps {
 public:
  /// @param lagrangian  callable at every scalar
  /// @param g0, g1      the first two configurations
  /// @throws NotFinite, OutsideDomain where the configurations are no numbers, or the Lagrangian refuses them
  EulerLagrangeSteps(L lagrangian, Element<G, S> const& g0, Element<G, S> const& g1)
      : lagrangian_(std::move(lagrangian)),
        before_(g0),
        now_(g1),
        end_momentum_(D2(lagrangian_, g0, g1)),
        solver_(g1) {}

  /// Takes a step: solves \f$D_2L(g_0, g_1) + D_1L(g_1, g) = 0\f$.
  /// @return the next configuration
  /// @throws NotConverged, Singular  where the step is too long for the discrete Lagrangian to be regular;
  /// the motion stays where it was
  Element<G, S> const& advance() {
    Element<G, S> const next = solver_.solve(
        [&](auto const& g) { return like(g, end_momentum_) + D1(lagrangian_, like(g, now_), g); },
        now_ * inverse(before_) * now_);
    end_momentum_ = D2(lagrangian_, now_, next);
    before_ = now_;
    return now_ = next;
  }
  /// The configuration before the last one.
  Element<G, S> const& before() const { return before_; }
  /// The last configuration.
  Element<G, S> const& configuration() const { return now_; }
  /// \f$D_2L(g_0, g_1)\f$ at the last two configurations: the momentum in space after the last step.
  Momentum<G, S> const& momentum() const { return end_momentum_; }
  /// How the last step was solved for.
  Report const& report() const { return solver_.report(); }

 private:
  L lagrangian_;
  Element<G, S> before_, now_;
  Momentum<G, S> end_momentum_;
  PredictorCorrector<G, S> solver_;
};

}  // namespace actio
