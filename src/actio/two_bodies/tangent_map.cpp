// The tangent map of steps, by dual numbers through the kernel itself.
#include <Eigen/Dense>

#include "actio/numbers/derivative.hpp"
#include "actio/two_bodies/two_bodies.hpp"

namespace actio::bodies {
namespace {

/// Tangent vectors in the axes of the steps: place, momentum, and of each body the turn q -> q exp(theta) and
/// the body momentum.
using Tangent = Eigen::Matrix<double, 18, 1>;

template <class T>
InverseMoments<T> over(InverseMoments<double> const& body) {
  InverseMoments<T> lifted;
  for (int i = 0; i < 3; ++i) lifted.J[i] = T(body.J[i]);
  lifted.d12 = T(body.d12), lifted.d23 = T(body.d23), lifted.d13 = T(body.d13);
  return lifted;
}
template <class T>
std::vector<PairStage<T>> over(std::vector<PairStage<double>> const& stages) {
  std::vector<PairStage<T>> lifted;
  for (auto const& s : stages) lifted.push_back({s.time, s.kick, over<T>(s.body_1), over<T>(s.body_2)});
  return lifted;
}

/// A state without its tangent vectors.
template <class T>
PairState<T> over(PairState<double> const& state) {
  PairState<T> lifted;
  auto const copy = [](auto& to, auto const& from) {
    for (std::size_t i = 0; i < from.value.size(); ++i)
      to.value[i] = T(from.value[i]), to.rest[i] = T(from.rest[i]);
  };
  copy(lifted.place, state.place), copy(lifted.momentum, state.momentum);
  copy(lifted.body_1, state.body_1), copy(lifted.body_2, state.body_2);
  copy(lifted.attitude_1, state.attitude_1), copy(lifted.attitude_2, state.attitude_2);
  return lifted;
}
Four<double> values(Summed<double, 4> const& q) { return q.value; }
template <class T>
Four<double> values(Summed<T, 4> const& q) {
  return {q.value[0].value, q.value[1].value, q.value[2].value, q.value[3].value};
}

/// Puts a tangent vector in the direction `a` of dual numbers.
template <class T>
void set_direction(PairState<T>& state, int a, Tangent const& v, PairSetting const& setting) {
  auto const turn = [&](Summed<T, 4>& q, int at) {
    Four<double> const rate = compose(values(q), Four<double>{0, v[at] / 2, v[at + 1] / 2, v[at + 2] / 2});
    for (int i = 0; i < 4; ++i) q.value[i].part[a] = rate[i], q.rest[i].part[a] = 0;
  };
  auto const shift = [&](Summed<T, 3>& x, int at, double unit) {
    for (int i = 0; i < 3; ++i) x.value[i].part[a] = unit * v[at + i], x.rest[i].part[a] = 0;
  };
  shift(state.place, 0, 1), shift(state.momentum, 3, 1);
  turn(state.attitude_1, 6), shift(state.body_1, 9, setting.unit_1);
  turn(state.attitude_2, 12), shift(state.body_2, 15, setting.unit_2);
}
template <class T>
Tangent direction(PairState<T> const& state, int a, PairSetting const& setting) {
  Tangent v;
  auto const turn = [&](Summed<T, 4> const& q, int at) {
    Four<double> const x = values(q),
                       rate{q.value[0].part[a], q.value[1].part[a], q.value[2].part[a], q.value[3].part[a]},
                       seen = compose(Four<double>{x[0], -x[1], -x[2], -x[3]}, rate);
    for (int i = 0; i < 3; ++i) v[at + i] = 2 * seen[1 + i];
  };
  auto const shift = [&](Summed<T, 3> const& x, int at, double unit) {
    for (int i = 0; i < 3; ++i) v[at + i] = x.value[i].part[a] / unit;
  };
  shift(state.place, 0, 1), shift(state.momentum, 3, 1);
  turn(state.attitude_1, 6), shift(state.body_1, 9, setting.unit_1);
  turn(state.attitude_2, 12), shift(state.body_2, 15, setting.unit_2);
  return v;
}

/// A force over dual numbers, with what a third body adds to it.
template <class T, class Force>
struct InTime {
  Force const& force;
  ThirdBodyForce const* third;
  Kick<T> operator()(Three<T> const& X, Four<T> const& q1, Four<T> const& q2, double time) const {
    Kick<T> kick = force(X, q1, q2);
    if (third) third->add_to(kick, X, q1, q2, time);
    return kick;
  }
};

}  // namespace

template <class T>
PairState<T> TwoBodies::moved(PairState<T> const& from, long first, long count) const {
  if (tides_)
    throw OutsideDomain("tangent map of two bodies",
                        "there must be no tides, whose kicks depend on velocities; their number", 2, 0);
  auto const& kicks = options_.method.splitting.kicks;
  double const h = options_.step;
  auto const stages = over<T>(stages_);
  auto const run = [&](auto const& force) {
    InTime<T, std::decay_t<decltype(force)>> const in_time{force, third_ ? &*third_ : nullptr};
    detail::PairSteps<T, std::decay_t<decltype(in_time)>> steps{
        setting_, stages, kicks.front() * h, kicks.back() * h, in_time, h, options_.start, first, count, from,
        5,        5};
    steps();
    return steps.state;
  };
  return std::visit(
      [&]<class F>(F const& force) {
        if constexpr (std::is_same_v<F, AnyOrderForce<>>)
          return run(AnyOrderForce<T>(first_, second_, options_.order, options_.G));
        else
          return run(force);
      },
      force_);
}

Eigen::Matrix<double, 18, 18> TwoBodies::tangent_map(long count) const {
  using D = Moved<double>;
  Eigen::Matrix<double, 18, 18> map, frames = Eigen::Matrix<double, 18, 18>::Identity();
  for (int column = 0; column < 18; column += batch) {
    auto state = over<D>(state_);
    for (int a = 0; a < batch; ++a) set_direction(state, a, Tangent::Unit(column + a), setting_);
    auto const end = moved(state, steps_, count);
    for (int a = 0; a < batch; ++a) map.col(column + a) = direction(end, a, setting_);
  }
  for (int at : {6, 9}) frames.block<3, 3>(at, at) = first_.axes;
  for (int at : {12, 15}) frames.block<3, 3>(at, at) = second_.axes;
  return frames * map * frames.transpose();
}

double TwoBodies::lyapunov_exponent(long count, long every) const {
  if (count < 1 || every < 1)
    throw OutsideDomain("Lyapunov exponent", "numbers of steps must be positive",
                        static_cast<double>(std::min(count, every)), 1);
  using D = Dual<double>;
  // Each part of a tangent vector in units of the motion itself.
  double const length = std::sqrt(dot(state_.place.value, state_.place.value)),
               rate = std::sqrt(setting_.mu / (length * length * length));
  Tangent unit = Tangent::Ones();
  unit.head<3>() *= length, unit.segment<3>(3) *= setting_.reduced_mass * length * rate;
  unit.segment<3>(9) *= rate * std::max({first_.inertia[0], first_.inertia[1], first_.inertia[2]});
  unit.segment<3>(15) *= rate * std::max({second_.inertia[0], second_.inertia[1], second_.inertia[2]});
  auto state = over<D>(state_);
  Tangent along = Tangent::Ones() / std::sqrt(18.0);
  double growth = 0;
  for (long done = 0; done < count;) {
    set_direction(state, 0, along.cwiseProduct(unit), setting_);
    long const next = std::min(every, count - done);
    state = moved(state, steps_ + done, next);
    along = direction(state, 0, setting_).cwiseQuotient(unit);
    growth += std::log(along.norm());
    along.normalize();
    done += next;
  }
  return growth / (static_cast<double>(count) * std::abs(options_.step));
}

}  // namespace actio::bodies
