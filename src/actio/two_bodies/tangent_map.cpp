// The tangent map of steps, by dual numbers through the kernel itself.
// In a unit of its own
#include <Eigen/Dense>

#include "actio/numbers/derivative.hpp"
#include "actio/two_bodies/two_bodies.hpp"

namespace actio::bodies {
namespace {

/// Tangent vectors in the axes of the steps: position, momentum, and of each body the turn q -> q exp(theta)
/// and the body momentum.
using Tangent = Eigen::Matrix<double, 18, 1>;

using D = Dual<double>;

InverseMoments<D> lifted(InverseMoments<double> const& body) {
  InverseMoments<D> result;
  for (int i = 0; i < 3; ++i) result.J[i] = D(body.J[i]);
  result.d12 = D(body.d12), result.d23 = D(body.d23), result.d13 = D(body.d13);
  return result;
}
std::vector<PairStage<D>> lifted(std::vector<PairStage<double>> const& stages) {
  std::vector<PairStage<D>> result;
  for (auto const& s : stages) result.push_back({s.time, s.kick, lifted(s.body_1), lifted(s.body_2)});
  return result;
}
template <std::size_t n>
Summed<D, n> lifted(Summed<double, n> const& sum) {
  Summed<D, n> result;
  for (std::size_t i = 0; i < n; ++i) result.value[i] = D(sum.value[i]), result.rest[i] = D(sum.rest[i]);
  return result;
}
/// A state without its tangent vector.
PairState<D> lifted(PairState<double> const& s) {
  return {lifted(s.position), lifted(s.momentum),   lifted(s.body_1),
          lifted(s.body_2),   lifted(s.attitude_1), lifted(s.attitude_2)};
}
Four<double> values(Summed<D, 4> const& q) {
  return {q.value[0].value, q.value[1].value, q.value[2].value, q.value[3].value};
}

/// Gives a state this tangent vector.
void set_direction(PairState<D>& state, Tangent const& v, PairSetting const& setting) {
  auto const turn = [&](Summed<D, 4>& q, int at) {
    Four<double> const rate = compose(values(q), Four<double>{0, v[at] / 2, v[at + 1] / 2, v[at + 2] / 2});
    for (int i = 0; i < 4; ++i) q.value[i].part[0] = rate[i], q.rest[i].part[0] = 0;
  };
  auto const shift = [&](Summed<D, 3>& x, int at, double unit) {
    for (int i = 0; i < 3; ++i) x.value[i].part[0] = unit * v[at + i], x.rest[i].part[0] = 0;
  };
  shift(state.position, 0, 1), shift(state.momentum, 3, 1);
  turn(state.attitude_1, 6), shift(state.body_1, 9, setting.unit_1);
  turn(state.attitude_2, 12), shift(state.body_2, 15, setting.unit_2);
}
/// The tangent vector of a state.
Tangent direction(PairState<D> const& state, PairSetting const& setting) {
  Tangent v;
  auto const turn = [&](Summed<D, 4> const& q, int at) {
    Four<double> const x = values(q),
                       rate{q.value[0].part[0], q.value[1].part[0], q.value[2].part[0], q.value[3].part[0]},
                       seen = compose(Four<double>{x[0], -x[1], -x[2], -x[3]}, rate);
    for (int i = 0; i < 3; ++i) v[at + i] = 2 * seen[1 + i];
  };
  auto const shift = [&](Summed<D, 3> const& x, int at, double unit) {
    for (int i = 0; i < 3; ++i) v[at + i] = x.value[i].part[0] / unit;
  };
  shift(state.position, 0, 1), shift(state.momentum, 3, 1);
  turn(state.attitude_1, 6), shift(state.body_1, 9, setting.unit_1);
  turn(state.attitude_2, 12), shift(state.body_2, 15, setting.unit_2);
  return v;
}

}  // namespace

PairState<Dual<double>> TwoBodies::moved(PairState<Dual<double>> const& from, long first, long count) const {
  if (tides_)
    throw OutsideDomain("tangent map of two bodies",
                        "there must be no tides, whose kicks depend on velocities; their number", 2, 0);
  auto const& kicks = options_.method.splitting.kicks;
  double const h = options_.step;
  auto const stages = lifted(stages_);
  auto const run = [&](auto const& force) {
    detail::InTime<D, std::decay_t<decltype(force)>> const in_time{force, third_ ? &*third_ : nullptr};
    detail::PairSteps<D, std::decay_t<decltype(in_time)>> steps{
        setting_, stages, kicks.front() * h, kicks.back() * h, in_time, h, options_.start, first, count, from,
        5,        5};
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
    auto state = lifted(state_);
    set_direction(state, Tangent::Unit(column), setting_);
    map.col(column) = direction(moved(state, steps_, count), setting_);
  }
  for (int at : {6, 9}) frames.block<3, 3>(at, at) = first_.axes;
  for (int at : {12, 15}) frames.block<3, 3>(at, at) = second_.axes;
  return frames * map * frames.transpose();
}

double TwoBodies::lyapunov_exponent(long count, long every) const {
  if (count < 1 || every < 1)
    throw OutsideDomain("Lyapunov exponent", "numbers of steps must be positive",
                        static_cast<double>(std::min(count, every)), 1);
  // Each part of a tangent vector in units of the motion itself.
  double const length = std::sqrt(dot(state_.position.value, state_.position.value)),
               rate = std::sqrt(setting_.mu / (length * length * length));
  Tangent unit = Tangent::Ones();
  unit.head<3>() *= length, unit.segment<3>(3) *= setting_.reduced_mass * length * rate;
  unit.segment<3>(9) *= rate * std::max({first_.inertia[0], first_.inertia[1], first_.inertia[2]});
  unit.segment<3>(15) *= rate * std::max({second_.inertia[0], second_.inertia[1], second_.inertia[2]});
  auto state = lifted(state_);
  Tangent along = Tangent::Ones() / std::sqrt(18.0);
  double growth = 0;
  for (long done = 0; done < count;) {
    set_direction(state, along.cwiseProduct(unit), setting_);
    long const next = std::min(every, count - done);
    state = moved(state, steps_ + done, next);
    along = direction(state, setting_).cwiseQuotient(unit);
    growth += std::log(along.norm());
    along.normalize();
    done += next;
  }
  return growth / (static_cast<double>(count) * std::abs(options_.step));
}

}  // namespace actio::bodies
