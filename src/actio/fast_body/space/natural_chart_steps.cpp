#include "actio/fast_body/space/natural_chart_steps.hpp"

namespace actio::bodies {

NaturalChartSteps::NaturalChartSteps(PrincipalInertia const& inertia, Momentum<SO<3>, double> const& momentum,
                                     Element<SU2, double> const& attitude, double h,
                                     std::vector<double> fractions)
    : step_(h),
      axes_(inertia.axes),
      unit_(unit_of(inertia)),
      scheme_(over(inertia.inertia.moments, unit_)),
      fractions_(std::move(fractions)),
      guesses_(fractions_.size()) {
  if (!is_finite(h)) throw NotFinite("natural-chart steps: step");
  if (h == 0) throw OutsideDomain("natural-chart steps", "the step must differ from zero", 0, 0);
  double sum = 0;
  for (double const f : fractions_) sum += f;
  if (!(std::abs(sum - 1) <= 1e-12))
    throw OutsideDomain("natural-chart steps", "the fractions of a step must add up to 1", sum, 1);
  if (!is_finite(momentum.components)) throw NotFinite("natural-chart steps: body momentum");
  if (!is_finite(attitude.value)) throw NotFinite("natural-chart steps: attitude");
  Eigen::Vector4d const q = axes_.enter(restore(attitude).value);
  now_ = {over(axes_.enter(momentum.components), unit_), {q[0], q[1], q[2], q[3]}};
  if (!is_finite(dot(now_.direction, now_.direction)))
    throw NotFinite("natural-chart steps: momentum over inertia");
  if (!possible(now_.direction, h)) too_long();
}

FreeState NaturalChartSteps::state() const {
  if (!attitude_known_)
    throw OutsideDomain("natural-chart steps",
                        "the attitude is not known after steps with the momentum alone; steps with attitude",
                        0, 1);
  auto const q = plus(now_.attitude, compensation_.attitude);
  return {body_momentum(), {SU2{}, axes_.leave(Eigen::Vector4d(q[0], q[1], q[2], q[3])).normalized()}};
}

Three<double> NaturalChartSteps::guess(std::size_t stage, Three<double> const& p) const {
  auto const& [v1, v2, v3] = guesses_[stage];
  if (taken_ == 0) return scheme_.velocity(p);
  if (taken_ == 1) return v1;
  if (taken_ == 2) return plus(v1, minus(v1, v2));
  return plus(times(3, minus(v1, v2)), v3);
}

Four<double> NaturalChartSteps::change_of(NaturalChartStep::StepRotation const& turn) {
  double const half = std::sqrt(turn.angle_squared) / 2, ratio = half > 0 ? std::sin(half) / (2 * half) : 0.5;
  Three<double> const e = times(ratio, turn.v);
  return {-dot(e, e) / (1 + std::cos(half)), e[0], e[1], e[2]};
}

bool NaturalChartSteps::possible(Three<double> m, double h) const {
  for (double const f : fractions_) {
    auto const turn = scheme_.followed(times(f * h, m));
    if (!turn.found) return false;
    m = plus(m, momentum_change(change_of(turn), m));
  }
  return true;
}

void NaturalChartSteps::too_long() const {
  auto const& m = now_.direction;
  // Moments are at most 1 here: no turn of less than pi has more than |p| = |y| (1 + pi/2 + 1) < 12.
  double const size = std::max({std::abs(m[0]), std::abs(m[1]), std::abs(m[2])}),
               share = *std::max_element(fractions_.begin(), fractions_.end());
  double low = 0, high = std::min(std::abs(step_), 12 / size / share);
  for (int i = 0; i < 60 && high - low > 1e-12 * high; ++i) {
    double const middle = (low + high) / 2;
    (possible(m, std::copysign(middle, step_)) ? low : high) = middle;
  }
  throw StepTooLong("natural-chart scheme", std::abs(step_), low);
}

}  // namespace actio::bodies
