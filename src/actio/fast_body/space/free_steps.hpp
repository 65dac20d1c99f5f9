// A free rigid body in three dimensions, in steps: compensated, and set back on its orbit from time to time.
//
//     FreeSteps motion(body, 0.1); // the Moser-Veselov scheme with the moments that make it exact
//     motion.advance(100000);
#pragma once

#include "actio/fast_body/space/compensated_half_turn.hpp"
#include "actio/fast_body/space/free_body.hpp"

namespace actio {

/// A free body in steps of one length.
///
/// The steps are compensated: what a step adds is summed with what the sums before have lost. The numbers of
/// a step are rounded once and for all, so that each step misses the orbit by a part of a rounding, always to
/// the same side; and next to the separatrix a miss grows as fast as the motion leaves the middle axis. So
/// every 64 steps, or more often where they are long, the state is projected back onto its orbit, of which
/// amount and energy are known, and the attitude is turned so that the momentum in space is what it was. That
/// takes the error next to the separatrix down to what one rounding of the start makes. Steps of more than
/// four radians there, of which one may pass by the middle axis more than once, are evaluated from the start,
/// each as `at` of the body does it.
class FreeSteps {
 public:
  /// @param body  where it starts
  /// @param h     step, time, not zero; negative steps go back in time
  /// @throws NotFinite, OutsideDomain  where the step is no number, or zero
  FreeSteps(FreeBody body, double h) : FreeSteps(body, h, checked(body, h)) {
    leaps_ = body_.near_separatrix() && std::abs(h) * body_.pace() > 4;
  }
  /// The same for the parameters of another method, such as \ref FreeBody::moser_veselov_parameters.
  FreeSteps(FreeBody body, double h, StepParameters<double> const& parameters)
      : body_(std::move(body)),
        step_(h),
        turn_(parameters),
        now_{body_.start(), {{}, {}}},
        above_(above(body_)),
        energy_(energy(now_)),
        space_(in_space(now_)) {
    // Parameters belong to an orbit, and long steps beside it depart from it: where they are longer than a
    // few radians each one must be set back. Next to the separatrix what was missed grows even between short
    // steps.
    double const pace = std::abs(h) * body_.pace(),
                 often = std::max(4 * pace * pace, body_.near_separatrix() ? 16 * pace : 0.0);
    block_ = often > 1 ? std::max(1L, static_cast<long>(64 / often)) : 64;
  }

  /// Steps with momentum and attitude. One call with 1000 and a thousand calls with 1 give the same digits.
  /// @throws OutsideDomain  after \ref advance_momentum, after which the attitude is unknown
  void advance(long count = 1) {
    require_attitude();
    take(
        count,
        [turn = turn_](CompensatedState<double> & state) __attribute__((always_inline)) { turn.step(state); },
        [this] { restore_momentum(), restore_attitude(); });
  }
  /// Steps with the momentum alone. Nothing of the attitude is computed, which is then unknown.
  void advance_momentum(long count = 1) {
    if (count > 0) attitude_known_ = false;
    take(
        count,
        [turn = turn_](CompensatedState<double> & state)
            __attribute__((always_inline)) { turn.step_momentum(state); },
        [this] { restore_momentum(); });
  }

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

  FreeState seen() const {
    FrameState<double> state = now_.state;
    for (int i = 0; i < 3; ++i) state.direction[i] += now_.compensation.direction[i];
    for (int i = 0; i < 4; ++i) state.attitude[i] += now_.compensation.attitude[i];
    return body_.state(state);
  }
  void require_attitude() const {
    if (!attitude_known_)
      throw OutsideDomain(
          "free steps", "the attitude is not known after steps with the momentum alone; steps with attitude",
          0, 1);
  }
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
  static Three<double> above(FreeBody const& body) {
    InverseMoments<double> const& J = body.inverse_moments();
    Orbit<double> const orbit(J, body.start().direction);
    double const first = std::abs(orbit.a), middle = std::abs(orbit.beside), third = std::abs(orbit.b);
    if (middle <= first && middle <= third) return {J.d12, 0, -J.d23};
    return first < third ? Three<double>{0, -J.d12, -J.d13} : Three<double>{J.d13, J.d23, 0};
  }
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

  /// Back on the orbit, along the gradients of amount and energy.
  void restore_momentum() {
    Three<Wide> const u = direction(now_), w = gradient(u);
    Wide const uu = dot(u, u), uw = dot(u, w), ww = dot(w, w);
    // u + alpha u + beta w: uu - 1 + 2 (alpha uu + beta uw) = 0, uw - E + 2 (alpha uw + beta ww) = 0.
    Wide const length = (1 - uu) / 2, lack = (energy_ - uw) / 2, det = uu * ww - uw * uw;
    // Where the gradients are parallel, next to a steady turn, or one of them vanishes, the length alone.
    bool const parallel = !(det > Wide(1e-8) * uu * ww);
    Wide const alpha = parallel ? length / uu : (length * ww - lack * uw) / det,
               beta = parallel ? 0 : (lack * uu - length * uw) / det;
    Three<double> change;
    for (int i = 0; i < 3; ++i) change[i] = static_cast<double>(alpha * u[i] + beta * w[i]);
    CompensatedState<double>::add(now_.state.direction, now_.compensation.direction, change);
  }

  Four<Wide> attitude(CompensatedState<double> const& p) const {
    Four<Wide> q;
    for (int i = 0; i < 4; ++i) q[i] = Wide(p.state.attitude[i]) + p.compensation.attitude[i];
    return q;
  }
  /// The momentum in space, over its amount.
  Three<Wide> in_space(CompensatedState<double> const& p) const {
    Three<Wide> const u = direction(p);
    Four<Wide> const q = attitude(p),
                     turned = compose(compose(q, {0, u[0], u[1], u[2]}), {q[0], -q[1], -q[2], -q[3]});
    Wide const size = 1 / (q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3]);
    return {turned[1] * size, turned[2] * size, turned[3] * size};
  }
  /// A quaternion of unit length, turned so that the momentum in space is where it was.
  void restore_attitude() {
    Four<Wide> const q = attitude(now_);
    Three<Wide> const w = in_space(now_),
                      c{w[1] * space_[2] - w[2] * space_[1], w[2] * space_[0] - w[0] * space_[2],
                        w[0] * space_[1] - w[1] * space_[0]};
    Wide const stretch = (1 - (q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3])) / 2;
    Four<Wide> const turned = compose<Wide>({stretch, c[0] / 2, c[1] / 2, c[2] / 2}, q);
    Four<double> change;
    for (int i = 0; i < 4; ++i) change[i] = static_cast<double>(turned[i]);
    CompensatedState<double>::add(now_.state.attitude, now_.compensation.attitude, change);
  }

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

}  // namespace actio
