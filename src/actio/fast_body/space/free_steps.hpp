// A free rigid body in three dimensions, in steps: compensated, and set back on its orbit from time to time.
//
//     FreeSteps motion(body, 0.1); // the Moser-Veselov scheme with the moments that make it exact
//     motion.advance(100000);
#pragma once

#include "actio/fast_body/space/compensated_half_turn.hpp"
#include "actio/fast_body/space/free_body.hpp"

namespace actio::bodies {

/// A free body in steps of one length: the exact motion (\ref ch05a), or that of another method.
///
/// The steps are compensated: what a step adds is summed with what the sums before have lost. The numbers of
/// a step are rounded once and for all, so that each step misses the orbit by a part of a rounding, always to
/// the same side; and next to the separatrix a miss grows as fast as the motion leaves the middle axis. So
/// every 64 steps, or more often where they are long, the state is projected back onto its orbit, of which
/// magnitude and energy are known, and the attitude is turned so that the momentum in space is what it was.
/// That takes the error next to the separatrix down to what one rounding of the start makes. Steps of more
/// than four radians there, of which one may pass by the middle axis more than once, are evaluated from the
/// start, each as `at` of the body does it.
///
/// \snippet bodies.cpp free_steps
class FreeSteps {
 public:
  /// @param body  where it starts
  /// @param h     step, time, not zero; negative steps go back in time
  /// @throws NotFinite, OutsideDomain  where the step is no number, or zero
  FreeSteps(FreeBody body, double h) : FreeSteps(body, h, checked(body, h)) {
    leaps_ = body_.near_separatrix() && std::abs(h) * body_.pace() > 4;
  }
  /// The same for the parameters of another method, such as \ref FreeBody::moser_veselov_parameters.
  FreeSteps(FreeBody body, double h, StepParameters<double> const& parameters);

  /// Steps with momentum and attitude. One call with 1000 and a thousand calls with 1 give the same digits.
  /// @throws OutsideDomain  after \ref advance_momentum, after which the attitude is unknown
  void advance(long count = 1);
  /// Steps with the momentum alone. Nothing of the attitude is computed, which is then unknown.
  void advance_momentum(long count = 1);

  /// Saves, or restores, what the next step depends on besides body, step and method: `memory(numbers...)`
  /// takes each of them by reference.
  template <class Memory>
  void remember(Memory& memory) { memory(now_, taken_, since_, attitude_known_); }

  /// The body, at its start.
  FreeBody const& body() const { return body_; }
  double step() const { return step_; }
  /// Momentum and attitude now.
  /// @throws OutsideDomain  after \ref advance_momentum
  FreeState state() const {
    require_attitude();
    return seen();
  }
  /// The body momentum now.
  Momentum<SO<3>, double> body_momentum() const {
    Three<double> seen = now_.state.direction;
    for (int i = 0; i < 3; ++i) seen[i] += now_.compensation.direction[i];
    return body_.momentum_along(seen);
  }

 private:
  static StepParameters<double> checked(FreeBody const& body, double h) {
    if (!is_finite(h)) throw NotFinite("free steps: step");
    if (h == 0) throw OutsideDomain("free steps", "the step must differ from zero", 0, 0);
    return body.step_parameters(h);
  }

  FreeState seen() const;
  void require_attitude() const;
  template <class Step, class Restore>
  void take(long count, Step const& step, Restore const& restore) {
    taken_ += std::max(0L, count);
    if (leaps_ && count > 0) {
      now_ = {body_.frame_state_at(static_cast<double>(taken_) * step_), {{}, {}}};
      return;
    }
    while (count > 0) {
      long const now = std::min(count, block_ - since_);
      // In a local variable, so that the compiler can use registers.
      CompensatedState<double> state = now_;
      for (long k = 0; k < now; ++k) step(state);
      now_ = state;
      count -= now, since_ += now;
      if (since_ == block_) restore(), since_ = 0;
    }
  }

  using Wide = long double;
  Three<Wide> direction(CompensatedState<double> const& p) const {
    Three<Wide> u;
    for (int i = 0; i < 3; ++i) u[i] = Wide(p.state.direction[i]) + p.compensation.direction[i];
    return u;
  }
  /// \f$J_i-J_n\f$, with the axis n for which \f$2H-J_n\f$ is smallest.
  static Three<double> above(FreeBody const& body);
  /// \f$2H-J_n\f$ for a momentum of length 1: what tells orbits apart next to the separatrix, next to a
  /// steady turn, and for bodies that are nearly symmetric, where the energy itself has no digits for it.
  Wide energy(CompensatedState<double> const& p) const {
    Three<Wide> const u = direction(p), w = gradient(u);
    return dot(u, w) / dot(u, u);
  }
  /// Half its gradient.
  Three<Wide> gradient(Three<Wide> const& u) const {
    return {above_[0] * u[0], above_[1] * u[1], above_[2] * u[2]};
  }

  /// Back on the orbit, along the gradients of magnitude and energy.
  void restore_momentum();

  Four<Wide> attitude(CompensatedState<double> const& p) const {
    Four<Wide> q;
    for (int i = 0; i < 4; ++i) q[i] = Wide(p.state.attitude[i]) + p.compensation.attitude[i];
    return q;
  }
  /// The momentum in space, over its magnitude.
  Three<Wide> in_space(CompensatedState<double> const& p) const;
  /// A quaternion of unit length, turned so that the momentum in space is where it was.
  void restore_attitude();

  FreeBody body_;
  double step_;
  CompensatedHalfTurn<double> turn_;
  CompensatedState<double> now_;
  Three<double> above_;
  Wide energy_;
  Three<Wide> space_;
  bool attitude_known_ = true;
  long block_;      ///< steps between two restorations; each costs as much as a few steps
  long since_ = 0;  ///< steps since the last restoration
  long taken_ = 0;
  bool leaps_ = false;  ///< whether each state is evaluated from the start instead
};

}  // namespace actio::bodies
