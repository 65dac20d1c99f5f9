#include "actio/two_bodies/tides.hpp"

#include <numbers>

namespace actio::bodies {
namespace {

double size_of(Tide const& tide, double m1, double m2, double G) {
  if (!(tide.density > 0)) throw OutsideDomain("tides", "the density must be positive", tide.density, 0);
  if (!(tide.reference > 0))
    throw OutsideDomain("tides", "the reference radius must be positive", tide.reference, 0);
  if (!(tide.love >= 0)) throw OutsideDomain("tides", "the Love number must not be negative", tide.love, 0);
  double const volume = 3 / (4 * std::numbers::pi * tide.density);
  return 1.5 * tide.love * volume * volume * G * m1 * m1 * m2 * m2 * std::sin(2 * tide.lag) / tide.reference;
}
double slow_of(Tide const& tide, Three<double> const& I, double G) {
  return std::sqrt(6 / (std::numbers::pi * G * tide.density)) / std::max({I[0], I[1], I[2]});
}
/// The torque in space on a body that turns by the rate gamma against the orbit.
Three<double> torque_of(Three<double> const& gamma, double size, double slow) {
  double const rate = std::sqrt(dot(gamma, gamma)), least = std::abs(size) * slow;
  double const factor = rate > 0 || least > 0 ? -size / std::max(rate, least) : 0;
  return {factor * gamma[0], factor * gamma[1], factor * gamma[2]};
}

}  // namespace

Tides::Tides(Tide const& first, Tide const& second, ExtendedBody const& one, ExtendedBody const& two,
             double G)
    : inertia_1_(one.inertia),
      inertia_2_(two.inertia),
      size_1_(size_of(first, one.mass(), two.mass(), G)),
      size_2_(size_of(second, one.mass(), two.mass(), G)),
      slow_1_(slow_of(first, one.inertia, G)),
      slow_2_(slow_of(second, two.inertia, G)) {}

Tides::Rates Tides::rates(PairState<double> const& state, PairSetting<double> const& setting) const {
  auto const &X = state.position.value, &P = state.momentum.value;
  double const square = dot(X, X), sixth = square * square * square;
  Three<double> orbit = cross_product(X, P);
  for (double& x : orbit) x /= setting.reduced_mass * square;
  auto const torque = [&](Summed<double, 3> const& p, Summed<double, 4> const& q, Three<double> const& I,
                          double unit, double size, double slow) {
    Three<double> omega;
    for (int i = 0; i < 3; ++i) omega[i] = p.value[i] / (unit * I[i]);
    Three<double> gamma = minus(turned_by(q.value, omega), orbit);
    double const along = dot(gamma, X) / square;
    for (int i = 0; i < 3; ++i) gamma[i] -= along * X[i];
    return torque_of(gamma, size / sixth, slow);
  };
  Three<double> const t1 = torque(state.body_1, state.attitude_1, inertia_1_, setting.unit_1, size_1_,
                                  slow_1_),
                      t2 = torque(state.body_2, state.attitude_2, inertia_2_, setting.unit_2, size_2_,
                                  slow_2_);
  // [tidal_force]
  Three<double> force = cross_product(X, plus(t1, t2));
  for (double& x : force) x /= square;
  // [tidal_force]
  return {force, seen_by(state.attitude_1.value, t1), seen_by(state.attitude_2.value, t2)};
}

void Tides::kick(PairState<double>& state, PairSetting<double> const& setting, double time) const {
  auto const moved = [&](PairState<double>& at, Rates const& rate, double t) {
    auto const times = [](double c, Three<double> const& v) {
      return Three<double>{c * v[0], c * v[1], c * v[2]};
    };
    at.momentum.add(times(t, rate.force));
    at.body_1.add(times(t * setting.unit_1, rate.torque_1));
    at.body_2.add(times(t * setting.unit_2, rate.torque_2));
  };
  PairState<double> middle = state;
  moved(middle, rates(state, setting), time / 2);
  moved(state, rates(middle, setting), time);
}

}  // namespace actio::bodies
