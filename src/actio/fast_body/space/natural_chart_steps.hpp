// A free rigid body in steps of the natural-chart scheme, and of its compositions.
//
//     NaturalChartSteps motion(inertia, momentum, attitude, 0.01);               // order 2
//     NaturalChartSteps better(inertia, momentum, attitude, 0.1, suzuki<double>()); // order 4: the scheme is
//     its own adjoint
//
// A step of -h undoes one of h, since the discrete Lagrangian is the same at f and at its inverse. So
// substeps by the fractions of composition.hpp make steps of higher order.
#pragma once

#include <Eigen/Core>

#include <vector>

#include "actio/fast_body/space/compensated_half_turn.hpp"
#include "actio/fast_body/space/free_body.hpp"
#include "actio/fast_body/space/natural_chart_step.hpp"

namespace actio::bodies {

/// A free body in steps of one length, by the natural-chart scheme.
///
/// The momentum in the body is turned back by what the attitude is turned by, so that its magnitude and the
/// momentum in space are conserved to rounding, whatever the residual of Newton's method. Both are summed
/// with what the sums before have lost. Each search begins where the three before it point to.
class NaturalChartSteps {
 public:
  /// @param inertia    of the body, by principal moments or in a frame of any choice; momentum and attitude
  ///                   are of the same frame
  /// @param momentum   body momentum at the start, energy x time
  /// @param attitude   at the start, body to space
  /// @param h          step, time, not zero
  /// @param fractions  of a step, for its substeps; they add up to 1
  /// @throws NotFinite, OutsideDomain where a number is none, the step is zero, the fractions do not add up
  ///         to 1, or the quaternion is not near unit length
  /// @throws StepTooLong               where the first step has no solution: the chart ends at half a turn
  NaturalChartSteps(PrincipalInertia const& inertia, Momentum<SO<3>, double> const& momentum,
                    Element<SU2, double> const& attitude, double h, std::vector<double> fractions = {1});

  /// Steps with momentum and attitude.
  /// @throws StepTooLong  where a step has no solution; the body is then at the last step that had one
  void advance(long count = 1) { take<true>(count); }
  /// Steps with the momentum alone.
  void advance_momentum(long count = 1) {
    if (count > 0) attitude_known_ = false;
    take<false>(count);
  }

  /// Saves, or restores, what the next step depends on besides body and step: `memory(numbers...)` takes each
  /// of them by reference.
  template <class Memory>
  void remember(Memory& memory) { memory(now_, compensation_, taken_, attitude_known_, guesses_); }

  /// The next step guesses from its momentum alone: those before it were of another length.
  void forget_steps() { taken_ = 0; }

  double step() const { return step_; }
  /// Momentum and attitude now.
  /// @throws OutsideDomain  after \ref advance_momentum, after which the attitude is unknown
  FreeState state() const;
  /// The body momentum now, energy x time.
  Momentum<SO<3>, double> body_momentum() const {
    auto const p = plus(now_.direction, compensation_.direction);
    return {SO<3>{}, axes_.leave(Eigen::Vector3d(Eigen::Vector3d(p[0], p[1], p[2]) * unit_))};
  }

 private:
  /// The turns of the last three steps, the latest first.
  struct Guess {
    Three<double> v1, v2, v3;
  };

  static double unit_of(PrincipalInertia const& inertia) {
    if (!is_finite(inertia.inertia.moments)) throw NotFinite("natural-chart steps: moments of inertia");
    return MiddleAxisFrame(inertia).unit();
  }
  static Three<double> over(Eigen::Vector3d const& x, double unit) {
    return {x[0] / unit, x[1] / unit, x[2] / unit};
  }
  static Three<double> times(double c, Three<double> const& x) { return {c * x[0], c * x[1], c * x[2]}; }
  static Three<double> cross(Three<double> const& a, Three<double> const& b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
  }

  Three<double> guess(std::size_t stage, Three<double> const& p) const;
  /// The relative motion of a turn: \f$e-1\f$, so that nothing is lost where it is small.
  static Four<double> change_of(NaturalChartStep::StepRotation const& turn);
  /// The momentum on the other side of a turn, less the momentum on this side.
  static Three<double> momentum_change(Four<double> const& change, Three<double> const& m) {
    Three<double> const e{change[1], change[2], change[3]}, across = cross(e, m);
    return times(2, minus(cross(e, across), times(1 + change[0], across)));
  }

  template <bool with_attitude>
  void take(long count) {
    for (long n = 0; n < count; ++n) {
      auto const now = now_, compensation = compensation_;
      before_ = guesses_;
      for (std::size_t k = 0; k < fractions_.size(); ++k) {
        Three<double> const p = times(fractions_[k] * step_, now_.direction);
        auto turn = scheme_.turn(p, guess(k, p));
        if (!turn.found) turn = scheme_.followed(p);
        if (!turn.found) {
          now_ = now, compensation_ = compensation, guesses_ = before_;
          too_long();
        }
        guesses_[k] = {turn.v, guesses_[k].v1, guesses_[k].v2};
        Four<double> const change = change_of(turn);
        if constexpr (with_attitude)
          CompensatedState<double>::add(now_.attitude, compensation_.attitude,
                                        compose(now_.attitude, change));
        CompensatedState<double>::add(now_.direction, compensation_.direction,
                                      momentum_change(change, now_.direction));
      }
      ++taken_;
    }
  }

  /// Whether a whole step of length h has a solution.
  bool possible(Three<double> m, double h) const;
  /// @throws StepTooLong  with the longest step from here
  [[noreturn]] void too_long() const;

  double step_;
  PrincipalAxes axes_;
  double unit_;
  NaturalChartStep scheme_;
  std::vector<double> fractions_;
  FrameState<double> now_{}, compensation_{};  ///< the momentum in units of inertia, and the attitude
  std::vector<Guess> guesses_, before_;        ///< of each substep; before_ as they were when the step began
  long taken_ = 0;
  bool attitude_known_ = true;
};

}  // namespace actio::bodies
