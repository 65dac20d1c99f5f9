// Two bodies and the kernel of their steps.
// In a unit of its own
#include "actio/two_bodies/two_bodies.hpp"

#include <Eigen/Geometry>

#include "actio/fast_body/machine.hpp"
#include "actio/fast_body/space/torqued_body.hpp"

namespace actio::bodies {
namespace {

/// A power of two near the largest moment of inertia.
double unit_of(ExtendedBody const& body) {
  return std::exp2(std::ilogb(std::max({body.inertia[0], body.inertia[1], body.inertia[2]})));
}
InverseMoments<double> inverse_moments(ExtendedBody const& body, double part) {
  double const unit = unit_of(body);
  return detail::scaled(
      InverseMoments<double>({body.inertia[0] / unit, body.inertia[1] / unit, body.inertia[2] / unit}), part);
}
Eigen::Quaterniond axes_of(ExtendedBody const& body) { return Eigen::Quaterniond(body.axes).normalized(); }
Eigen::Quaterniond quaternion(Four<double> const& q) { return {q[0], q[1], q[2], q[3]}; }
Four<double> four(Eigen::Quaterniond const& q) { return {q.w(), q.x(), q.y(), q.z()}; }
Three<double> three(Eigen::Vector3d const& v) { return {v[0], v[1], v[2]}; }
template <class V>
Eigen::Vector3d vector(V const& v) { return {v[0], v[1], v[2]}; }

std::vector<PairStage<double>> stages_of(Splitting const& splitting, ExtendedBody const& first,
                                         ExtendedBody const& second, double h) {
  std::size_t const size = splitting.drifts.size();
  if (size == 0 || splitting.kicks.size() != size + 1)
    throw OutsideDomain("two bodies", "one kick more than drifts is needed; kicks",
                        static_cast<double>(splitting.kicks.size()), static_cast<double>(size + 1));
  std::vector<PairStage<double>> stages;
  auto const add = [&](double drift, double kick) {
    stages.push_back({drift * h, kick * h, inverse_moments(first, drift), inverse_moments(second, drift)});
  };
  for (std::size_t k = 0; k < size; ++k) add(splitting.drifts[k], splitting.kicks[k + 1]);
  add(splitting.drifts[size - 1] + splitting.drifts[0], 0);
  return stages;
}

struct Entered {
  Summed<double, 3> p;
  Summed<double, 4> q;
};
Entered entered(ExtendedBody const& body, FreeState const& state, double h) {
  if (!is_finite(state.body_momentum.components)) throw NotFinite("two bodies: body momentum");
  if (!is_finite(state.attitude.value)) throw NotFinite("two bodies: attitude");
  Eigen::Vector3d const M = body.axes.transpose() * Eigen::Vector3d(state.body_momentum.components);
  auto const q = restore(state.attitude).value;
  Eigen::Quaterniond const attitude = Eigen::Quaterniond(q[0], q[1], q[2], q[3]) * axes_of(body);
  return {{three(M / unit_of(body) * (h / 2)), {}}, {four(attitude.normalized()), {}}};
}
FreeState left(ExtendedBody const& body, Summed<double, 3> const& p, Summed<double, 4> const& q, double h) {
  Eigen::Vector3d const M = body.axes * vector(p.value) / (h / 2) * unit_of(body);
  Eigen::Quaterniond const attitude = (quaternion(q.value) * axes_of(body).conjugate()).normalized();
  return {{SO<3>{}, M}, {SU2{}, Eigen::Vector4d(attitude.w(), attitude.x(), attitude.y(), attitude.z())}};
}

}  // namespace

TwoBodies::TwoBodies(ExtendedBody first, ExtendedBody second, TwoBodyState const& start,
                     TwoBodyOptions options)
    : first_(std::move(first)),
      second_(std::move(second)),
      options_(std::move(options)),
      force_(SecondOrderForce<>(first_, second_, options_.G)) {
  double const h = options_.step, m1 = first_.mass(), m2 = second_.mass(), G = options_.G;
  if (!is_finite(h) || !is_finite(options_.start)) throw NotFinite("two bodies: step or time at the start");
  if (h == 0) throw OutsideDomain("two bodies", "the step must differ from zero", 0, 0);
  if (!(G > 0) || !is_finite(G))
    throw OutsideDomain("two bodies", "the constant of gravitation must be positive", G, 0);
  if (!is_finite(start.position) || !is_finite(start.momentum))
    throw NotFinite("two bodies: position or momentum");
  setting_ = {m1 / (m1 + m2) * m2,
              G * (m1 + m2),
              G * m1 * m2,
              h / 2 / unit_of(first_),
              h / 2 / unit_of(second_),
              first_.radius + second_.radius};
  if (options_.order == 4 && has_planes_of_symmetry(first_) && has_planes_of_symmetry(second_))
    force_ = FourthOrderForce<true>(first_, second_, G);
  else if (options_.order == 4)
    force_ = FourthOrderForce<false>(first_, second_, G);
  else if (options_.order != 2)
    force_ = AnyOrderForce<>(first_, second_, options_.order, G);
  if (options_.third) third_.emplace(*options_.third, first_, second_, G);
  if (options_.tides) tides_.emplace((*options_.tides)[0], (*options_.tides)[1], first_, second_, G);
  stages_ = stages_of(options_.method.splitting, first_, second_, h);
  auto const one = entered(first_, start.first, h), two = entered(second_, start.second, h);
  state_ = {{three(start.position), {}}, {three(start.momentum), {}}, one.p, two.p, one.q, two.q};
  require_apart("at the start");
}

void TwoBodies::step(long count) {
  if (count < 0)
    throw OutsideDomain("two bodies", "the number of steps must not be negative", static_cast<double>(count),
                        0);
  if (count == 0) return;
  PairState<double> const before = state_;
  long const steps_before = steps_;
  try {
    double nearest = tides_ ? HUGE_VAL : take(count);
    double const half = options_.step / 2;
    for (long k = 0; tides_ && k < count; ++k) {
      tides_->kick(state_, setting_, half);
      nearest = std::min(nearest, take(1));
      tides_->kick(state_, setting_, half);
    }
    require_apart("in the course of the motion", nearest);
  } catch (...) {
    state_ = before, steps_ = steps_before;
    throw;
  }
}

double TwoBodies::take(long count) {
  double const nearest = std::visit(
      [&]<class F>(F const& force) {
        detail::InTime<double, F> const in_time{force, third_ ? &*third_ : nullptr};
        auto steps = kernel<double>(in_time, steps_, count, state_, terms_1_, terms_2_);
        run_on_best_machine(steps);
        state_ = steps.state, terms_1_ = steps.terms_1, terms_2_ = steps.terms_2;
        return std::sqrt(steps.nearest_square);
      },
      force_);
  steps_ += count;
  return nearest;
}

TwoBodyState TwoBodies::state() const {
  return {vector(state_.position.value), vector(state_.momentum.value),
          left(first_, state_.body_1, state_.attitude_1, options_.step),
          left(second_, state_.body_2, state_.attitude_2, options_.step)};
}

Kick<double> TwoBodies::interaction() const {
  return std::visit(
      [&](auto const& force) {
        return force(state_.position.value, state_.attitude_1.value, state_.attitude_2.value);
      },
      force_);
}
double TwoBodies::potential() const {
  auto const k = interaction();
  return k.potential - setting_.strength * k.inverse;
}
double TwoBodies::energy() const {
  auto const turning = [](Summed<double, 3> const& p, ExtendedBody const& body, double unit) {
    double twice = 0;
    for (int i = 0; i < 3; ++i) twice += p.value[i] * p.value[i] / body.inertia[i];
    return twice / 2 / (unit * unit);
  };
  return dot(state_.momentum.value, state_.momentum.value) / (2 * setting_.reduced_mass) +
         turning(state_.body_1, first_, setting_.unit_1) + turning(state_.body_2, second_, setting_.unit_2) +
         potential();
}
Eigen::Vector3d TwoBodies::angular_momentum() const {
  Eigen::Vector3d const X = vector(state_.position.value), P = vector(state_.momentum.value);
  return X.cross(P) + vector(turned_by(state_.attitude_1.value, state_.body_1.value)) / setting_.unit_1 +
         vector(turned_by(state_.attitude_2.value, state_.body_2.value)) / setting_.unit_2;
}
double TwoBodies::nearness() const {
  return (first_.radius + second_.radius) / vector(state_.position.value).norm();
}

void TwoBodies::require_apart(char const* when, double nearest) const {
  double const here = nearness(), near = std::max(here, (first_.radius + second_.radius) / nearest);
  if (!is_finite(here) || !is_finite(state_.momentum.value[0]))
    throw NotFinite(std::string("two bodies, ") + when);
  if (near >= 1)
    throw OutsideDomain(
        std::string("two bodies, ") + when,
        "the spheres about the bodies must not meet, or the series of their potential need not "
        "converge; sum of the radii over the distance",
        near, 1);
}

TwoBodyState state_of_velocities(ExtendedBody const& first, ExtendedBody const& second,
                                 Eigen::Vector3d const& position, Eigen::Vector3d const& velocity,
                                 Element<SU2, double> const& attitude_1, Eigen::Vector3d const& omega_1,
                                 Element<SU2, double> const& attitude_2, Eigen::Vector3d const& omega_2) {
  auto const momentum = [](ExtendedBody const& body, Eigen::Vector3d const& omega) {
    Eigen::Vector3d const along = body.axes.transpose() * omega;
    return Momentum<SO<3>, double>{SO<3>{}, body.axes * along.cwiseProduct(vector(body.inertia))};
  };
  double const m = first.mass() / (first.mass() + second.mass()) * second.mass();
  return {position,
          m * velocity,
          {momentum(first, omega_1), attitude_1},
          {momentum(second, omega_2), attitude_2}};
}

}  // namespace actio::bodies
