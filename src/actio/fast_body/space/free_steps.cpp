#include "actio/fast_body/space/free_steps.hpp"

namespace actio::bodies {

FreeSteps::FreeSteps(FreeBody body, double h, StepParameters<double> const& parameters)
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

void FreeSteps::advance(long count) {
  require_attitude();
  take(
      count,
      [turn = turn_](CompensatedState<double> & state) __attribute__((always_inline)) { turn.step(state); },
      [this] { restore_momentum(), restore_attitude(); });
}

void FreeSteps::advance_momentum(long count) {
  if (count > 0) attitude_known_ = false;
  take(
      count,
      [turn = turn_](CompensatedState<double> & state)
          __attribute__((always_inline)) { turn.step_momentum(state); },
      [this] { restore_momentum(); });
}

FreeState FreeSteps::seen() const {
  FrameState<double> state = now_.state;
  for (int i = 0; i < 3; ++i) state.direction[i] += now_.compensation.direction[i];
  for (int i = 0; i < 4; ++i) state.attitude[i] += now_.compensation.attitude[i];
  return body_.state(state);
}

void FreeSteps::require_attitude() const {
  if (!attitude_known_)
    throw OutsideDomain("free steps",
                        "the attitude is not known after steps with the momentum alone; steps with attitude",
                        0, 1);
}

Three<double> FreeSteps::above(FreeBody const& body) {
  InverseMoments<double> const& J = body.inverse_moments();
  Orbit<double> const orbit(J, body.start().direction);
  double const first = std::abs(orbit.a), middle = std::abs(orbit.beside), third = std::abs(orbit.b);
  if (middle <= first && middle <= third) return {J.d12, 0, -J.d23};
  return first < third ? Three<double>{0, -J.d12, -J.d13} : Three<double>{J.d13, J.d23, 0};
}

void FreeSteps::restore_momentum() {
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

Three<FreeSteps::Wide> FreeSteps::in_space(CompensatedState<double> const& p) const {
  Three<Wide> const u = direction(p);
  Four<Wide> const q = attitude(p),
                   turned = compose(compose(q, {0, u[0], u[1], u[2]}), {q[0], -q[1], -q[2], -q[3]});
  Wide const size = 1 / (q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3]);
  return {turned[1] * size, turned[2] * size, turned[3] * size};
}

void FreeSteps::restore_attitude() {
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

}  // namespace actio::bodies
