// Tangent vectors of two bodies between steps: for the tangent map, and for growth rates.
#pragma once

#include <Eigen/Core>

#include "actio/numbers/derivative.hpp"
#include "actio/two_bodies/pair_steps.hpp"

namespace actio::bodies {

/// A tangent vector: of position, momentum, and of each body its turn \f$q\to q\,e^{\theta/2}\f$ and its
/// momentum.
using PairTangent = Eigen::Matrix<double, 18, 1>;

namespace detail {

template <std::size_t n>
Summed<Dual<double>, n> without_rates(Summed<double, n> const& sum) {
  Summed<Dual<double>, n> result;
  for (std::size_t i = 0; i < n; ++i) result.value[i] = sum.value[i], result.rest[i] = sum.rest[i];
  return result;
}
/// A state without its tangent vector.
inline PairState<Dual<double>> without_rates(PairState<double> const& s) {
  return {without_rates(s.position), without_rates(s.momentum),   without_rates(s.body_1),
          without_rates(s.body_2),   without_rates(s.attitude_1), without_rates(s.attitude_2)};
}
inline Four<double> values(Summed<Dual<double>, 4> const& q) {
  return {q.value[0].value, q.value[1].value, q.value[2].value, q.value[3].value};
}

/// Gives a state this tangent vector, in the axes of the steps.
inline void set_direction(PairState<Dual<double>>& state, PairTangent const& v,
                          PairSetting<double> const& setting) {
  auto const turn = [&](Summed<Dual<double>, 4>& q, int at) {
    Four<double> const rate = compose(values(q), Four<double>{0, v[at] / 2, v[at + 1] / 2, v[at + 2] / 2});
    for (int i = 0; i < 4; ++i) q.value[i].part[0] = rate[i], q.rest[i].part[0] = 0;
  };
  auto const shift = [&](Summed<Dual<double>, 3>& x, int at, double unit) {
    for (int i = 0; i < 3; ++i) x.value[i].part[0] = unit * v[at + i], x.rest[i].part[0] = 0;
  };
  shift(state.position, 0, 1), shift(state.momentum, 3, 1);
  turn(state.attitude_1, 6), shift(state.body_1, 9, setting.unit_1);
  turn(state.attitude_2, 12), shift(state.body_2, 15, setting.unit_2);
}
/// The tangent vector of a state, in the axes of the steps.
inline PairTangent direction(PairState<Dual<double>> const& state, PairSetting<double> const& setting) {
  PairTangent v;
  auto const turn = [&](Summed<Dual<double>, 4> const& q, int at) {
    Four<double> const x = values(q),
                       rate{q.value[0].part[0], q.value[1].part[0], q.value[2].part[0], q.value[3].part[0]},
                       seen = compose(Four<double>{x[0], -x[1], -x[2], -x[3]}, rate);
    for (int i = 0; i < 3; ++i) v[at + i] = 2 * seen[1 + i];
  };
  auto const shift = [&](Summed<Dual<double>, 3> const& x, int at, double unit) {
    for (int i = 0; i < 3; ++i) v[at + i] = x.value[i].part[0] / unit;
  };
  shift(state.position, 0, 1), shift(state.momentum, 3, 1);
  turn(state.attitude_1, 6), shift(state.body_1, 9, setting.unit_1);
  turn(state.attitude_2, 12), shift(state.body_2, 15, setting.unit_2);
  return v;
}

/// How a tangent vector grows: it is made as long as one again and again.
class Growth {
 public:
  /// @param unit  of each part of a tangent vector
  Growth(PairTangent const& unit, PairSetting<double> const& setting) : unit_(unit), setting_(setting) {}
  /// Gives a state the direction reached.
  void enter(PairState<Dual<double>>& state) const {
    set_direction(state, along_.cwiseProduct(unit_), setting_);
  }
  /// Takes the direction of the state that has moved.
  void leave(PairState<Dual<double>> const& state) {
    along_ = direction(state, setting_).cwiseQuotient(unit_);
    logarithm_ += std::log(along_.norm());
    along_.normalize();
  }
  /// The logarithm of what the vector has grown by.
  double logarithm() const { return logarithm_; }

 private:
  PairTangent unit_, along_ = PairTangent::Constant(1 / std::sqrt(18.0));
  PairSetting<double> setting_;
  double logarithm_ = 0;
};

}  // namespace detail
}  // namespace actio::bodies
