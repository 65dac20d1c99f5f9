#include "actio/fast_body/space/free_body.hpp"

namespace actio::bodies {

FreeBody::FreeBody(PrincipalInertia const& inertia, Momentum<SO<3>, double> const& momentum,
                   Element<SU2, double> const& attitude)
    : inertia_(inertia), frame_(inertia) {
  if (!is_finite(momentum.components)) throw NotFinite("free body: body momentum");
  if (!is_finite(attitude.value)) throw NotFinite("free body: attitude");
  magnitude_ = momentum.components.stableNorm();
  Eigen::Vector3d const direction =
      magnitude_ > 0 ? frame_.axes().enter(Eigen::Vector3d(momentum.components / magnitude_)).normalized()
                     : Eigen::Vector3d::UnitX();
  Element<SU2, double> const unit = restore(attitude);
  start_ = {frame_.counted(direction), frame_.enter(unit.value)};
  symmetry_ = axis_of_symmetry(frame_.moments());
  moments_ = InverseMoments<double>(frame_.moments());
  rate_ = magnitude_ / frame_.unit();
  if (!is_finite(rate_)) throw NotFinite("free body: momentum over inertia");
}

Momentum<SO<3>, double> FreeBody::body_momentum_at(double t) const {
  Three<double> u = start_.direction;
  if (symmetry_ >= 0) return momentum_along(symmetric_motion(moments_, symmetry_, u, 2 * half(t)));
  HalfTurn<double>(exact_flow_of_momentum<double>(moments_, u, half(t))).leap(u);
  return momentum_along(u);
}

FrameState<double> FreeBody::frame_state_at(double t) const {
  if (symmetry_ >= 0) return symmetric_motion(moments_, symmetry_, start_, 2 * half(t));
  FrameState<double> state = start_;
  HalfTurn<double>(step_parameters(t)).leap(state);
  return state;
}

StepParameters<double> FreeBody::moser_veselov_parameters(double h, int order) const {
  if (order < 2 || order % 2 != 0 || order > 40)
    throw OutsideDomain("free body", "the order of the scheme must be 2, 4, ... 40", order,
                        order < 2 ? 2 : 40);
  double const t = half(h);
  auto const modified = order == 2 ? ModifiedInertia<double>{1, 0}
                                   : modified_inertia<double>(moments_, start_.direction, t, order);
  bool found = false;
  StepParameters<double> const parameters = actio::bodies::moser_veselov_parameters<double>(
      half_step(moments_, modified, t), start_.direction, found);
  // With modified moments there may be roots again beyond the longest step; they do not grow out of the
  // identity.
  if (found && order > 2 && std::abs(t) * std::max(moments_.J[0], moments_.J[2]) > 0.5)
    found = !(longest_step(h, order) < std::abs(h));
  if (!found)
    throw StepTooLong("Moser-Veselov of order " + std::to_string(order), std::abs(h), longest_step(h, order));
  return parameters;
}

double FreeBody::longest_step(double h, int order) const {
  if (order == 2 && !(inertia_.inertia.lambda.minCoeff() < 0))
    return largest_step(
        inertia_.inertia,
        Momentum<SO<3>, double>{SO<3>{}, frame_.axes().enter(momentum_along(start_.direction).components)});
  auto const solvable = [&](double step) {
    double const t = half(step);
    auto const modified = order == 2 ? ModifiedInertia<double>{1, 0}
                                     : modified_inertia<double>(moments_, start_.direction, t, order);
    bool found = false;
    actio::bodies::moser_veselov_parameters<double>(half_step(moments_, modified, t), start_.direction,
                                                    found);
    return found;
  };
  if (!(rate_ > 0)) return std::abs(h);
  double low = 0, high = 0;
  for (double step = 0.01 / (rate_ * std::max(moments_.J[0], moments_.J[2])); high == 0; step *= 1.05) {
    double const next = std::min(step, std::abs(h));
    if (!solvable(next))
      high = next;
    else if (low = next; next == std::abs(h))
      return low;
  }
  for (int i = 0; i < 60 && high - low > 1e-12 * high; ++i) {
    double const middle = (low + high) / 2;
    (solvable(middle) ? low : high) = middle;
  }
  return low;
}

}  // namespace actio::bodies
