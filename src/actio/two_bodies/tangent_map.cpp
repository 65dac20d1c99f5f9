// The tangent map of steps, by dual numbers through the kernel itself.
// In a unit of its own
#include <Eigen/Dense>

#include "actio/two_bodies/pair_tangent.hpp"
#include "actio/two_bodies/two_bodies.hpp"

namespace actio::bodies {
namespace {
using D = Dual<double>;
}

PairState<Dual<double>> TwoBodies::moved(PairState<Dual<double>> const& from, long first, long count) const {
  if (tides_)
    throw OutsideDomain("tangent map of two bodies",
                        "there must be no tides, whose kicks depend on velocities; their number", 2, 0);
  auto const run = [&](auto const& force) {
    detail::InTime<D, std::decay_t<decltype(force)>> const in_time{force, third_ ? &*third_ : nullptr};
    auto steps = kernel<D>(in_time, first, count, from, 5, 5);
    steps();
    return steps.state;
  };
  return std::visit(
      [&]<class F>(F const& force) {
        if constexpr (std::is_same_v<F, AnyOrderForce<>>)
          return run(AnyOrderForce<D>(first_, second_, options_.order, options_.G));
        else
          return run(force);
      },
      force_);
}

Eigen::Matrix<double, 18, 18> TwoBodies::tangent_map(long count) const {
  Eigen::Matrix<double, 18, 18> map, frames = Eigen::Matrix<double, 18, 18>::Identity();
  for (int column = 0; column < 18; ++column) {
    auto state = detail::without_rates(state_);
    detail::set_direction(state, PairTangent::Unit(column), setting_);
    map.col(column) = detail::direction(moved(state, steps_, count), setting_);
  }
  for (int at : {6, 9}) frames.block<3, 3>(at, at) = first_.axes;
  for (int at : {12, 15}) frames.block<3, 3>(at, at) = second_.axes;
  return frames * map * frames.transpose();
}

PairTangent TwoBodies::tangent_units() const {
  double const length = std::sqrt(dot(state_.position.value, state_.position.value)),
               rate = std::sqrt(setting_.mu / length) / length;
  PairTangent unit = PairTangent::Ones();
  unit.head<3>() *= length, unit.segment<3>(3) *= setting_.reduced_mass * length * rate;
  unit.segment<3>(9) *= rate * std::max({first_.inertia[0], first_.inertia[1], first_.inertia[2]});
  unit.segment<3>(15) *= rate * std::max({second_.inertia[0], second_.inertia[1], second_.inertia[2]});
  return unit;
}

double TwoBodies::lyapunov_exponent(long count, long every) const {
  if (count < 1 || every < 1)
    throw OutsideDomain("Lyapunov exponent", "numbers of steps must be positive",
                        static_cast<double>(std::min(count, every)), 1);
  auto state = detail::without_rates(state_);
  detail::Growth growth(tangent_units(), setting_);
  for (long done = 0; done < count;) {
    long const next = std::min(every, count - done);
    growth.enter(state);
    state = moved(state, steps_ + done, next);
    growth.leave(state);
    done += next;
  }
  return growth.logarithm() / (static_cast<double>(count) * std::abs(options_.step));
}

}  // namespace actio::bodies
