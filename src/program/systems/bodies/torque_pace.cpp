// What the steps of a body under a torque are measured by.
#include <Eigen/Core>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "program/systems/bodies/torque_input.hpp"

namespace actio::scene {
namespace {

/// A NaN has no sign.
double told(double x) { return std::isnan(x) ? std::abs(x) : x; }

/// The attitude at the start, attitudes that fill the rotations evenly, and times that fill an interval:
/// multiples of the powers of one number, each without its whole part.
class Samples {
 public:
  Samples(Eigen::Vector4d const& first, double until, int count)
      : first_{first[0], first[1], first[2], first[3]}, until_(until), count_(count) {}
  bool next() { return ++n_ <= count_; }
  double time() const { return until_ * part(0.8566748838545029); }
  bodies::Four<double> attitude() const {
    if (n_ == 0) return first_;
    // Two circles, the squares of whose radii share the unit.
    double const u = part(0.7338918566271260), a = 2 * std::numbers::pi * part(0.6287067210378087),
                 b = 2 * std::numbers::pi * part(0.5385972572236101), r = std::sqrt(1 - u), s = std::sqrt(u);
    return {r * std::sin(a), r * std::cos(a), s * std::sin(b), s * std::cos(b)};
  }

 private:
  double part(double power) const { return std::fmod(power * n_, 1.0); }
  bodies::Four<double> first_;
  double until_;
  int count_, n_ = -1;
};

}  // namespace

double SceneTorque::pace_of(bodies::GravityGradient const& gradient, bodies::FreeState const& start) const {
  // With T the kinetic energy, E - rate <M, axis> is conserved, and |M| is at most sqrt(2 I_max T): a
  // quadratic inequality for the root of T.
  Eigen::Vector3d const moments = inertia_.inertia.moments;
  double const kinetic = kinetic_energy(inertia_, start.body_momentum),
               above = kinetic + potential(start.attitude.value, 0) -
                       rate_ * axis_.dot(Eigen::Vector3d(start.spatial_momentum().components)) -
                       gradient.strength / 2 * moments.minCoeff(),
               a = std::abs(rate_) * std::sqrt(moments.maxCoeff() / 2),
               root = a + std::sqrt(std::max(0.0, a * a + above));
  // A swing about a rest has at most the root of the strength for its frequency, since no moment is greater
  // than the sum of the other two.
  return std::max({fastest_turn(inertia_, root * root), std::sqrt(gradient.strength), std::abs(rate_)});
}

double SceneTorque::pace_of(bodies::UniformGravity const& gravity, bodies::FreeState const& start) const {
  Eigen::Vector3d const lever(gravity.lever[0], gravity.lever[1], gravity.lever[2]);
  double const fall = lever.norm() + potential(start.attitude.value, 0);
  return std::max(fastest_turn(inertia_, kinetic_energy(inertia_, start.body_momentum) + fall),
                  swing_of_weight(inertia_, lever));
}

void SceneTorque::check_start(FormulaPotential const& potential, bodies::FreeState const& start) const {
  auto const& q = start.attitude.value;
  bodies::NineEntries const rotation = bodies::rotation_entries({q[0], q[1], q[2], q[3]});
  bodies::NineEntries slope;
  double const value = potential(rotation, 0, slope);
  bodies::Three<double> const torque = bodies::torque_of_slope(rotation, slope);
  if (!is_finite(value) || !is_finite(bodies::dot(torque, torque)))
    throw SceneError(place_, fmt::format("potential: at the start it is {}, and the torque [{}, {}, {}], "
                                         "where finite numbers are needed",
                                         told(value), told(torque[0]), told(torque[1]), told(torque[2])));
}

double SceneTorque::pace_of(bodies::PotentialTorque<FormulaPotential> const& torque,
                            bodies::FreeState const& start, double until,
                            std::vector<std::string>& remarks) const {
  check_start(torque.function(), start);
  Eigen::Matrix3d const inverse = inertia_.inverse_tensor();
  double const kinetic = kinetic_energy(inertia_, start.body_momentum),
               first = potential(start.attitude.value, 0);
  double least = first, most = first, swing = 0, lightest = 0;
  // As many as take about a tenth of a second.
  auto const operations = static_cast<double>(torque.function().operations_of_curvature());
  int const count = std::clamp(static_cast<int>(2e7 / (operations + 1)), 20, 2000);
  for (Samples samples(start.attitude.value, formula_in_time_ ? until : 0, count); samples.next();) {
    bodies::NineEntries const rotation = bodies::rotation_entries(samples.attitude());
    bodies::NineEntries slope;
    double const V = torque.function()(rotation, samples.time(), slope);
    Eigen::Matrix3d const K = torque.function().curvature(rotation, samples.time());
    // The body does not come where the potential has no value, or is above the energy.
    if (!is_finite(V) || !is_finite(K) || (!formula_in_time_ && V > kinetic + first)) continue;
    least = std::min(least, V), most = std::max(most, V);
    swing = std::max(swing, swing_frequency(inertia_, K));
    Eigen::Vector3d const t(bodies::torque_of_slope(rotation, slope).data());
    if (magnitude(t) > 0) lightest = std::max(lightest, t.normalized().dot(inverse * t.normalized()));
  }
  // What falls turns about the axes that there are torques about. Where the energy is not conserved it may
  // come from as high as there is.
  double const fall = (formula_in_time_ ? most : first) - least, turn = fastest_turn(inertia_, kinetic);
  double const moves = std::max(std::hypot(turn, std::sqrt(2 * fall * lightest)), swing);
  if (!formula_in_time_) return moves;
  ChangeInTime change{least, most};
  for (Samples samples(start.attitude.value, until, 3); samples.next();)
    change.join(torque.function().change(bodies::rotation_entries(samples.attitude()), until,
                                         moves * moves * (change.most - change.least)));
  if (!change.settled)
    remarks.push_back(fmt::format(
        "potential: from t = {:.9g} to {:.9g} it may change faster than the steps know of: the bound of "
        "its second derivative by the time is {:.2g}, and {:.2g} was found",
        change.from, change.to, change.bound, change.bend));
  return std::max(moves, change.frequency());
}

double SceneTorque::pace_of_formulas(bodies::FreeState const& start, double until) const {
  auto const& q = start.attitude.value;
  Eigen::Matrix3d const inverse = inertia_.inverse_tensor();
  Eigen::Vector3d const w = inverse * start.body_momentum.components;
  // From rest a body turns by a radian in the time sqrt(2/|w'|).
  double fastest = 0;
  constexpr int times = 200;
  for (int k = 0; k <= times; ++k) {
    double const t = until * k / times;
    auto const torque = (*formulas_)({q[0], q[1], q[2], q[3]}, t, {w[0], w[1], w[2]}, t);
    Eigen::Vector3d const change = inverse * Eigen::Vector3d(torque[0], torque[1], torque[2]);
    if (!is_finite(change)) {
      if (k > 0) continue;
      formula_torque_keys.body.fail_at(
          table_, 0,
          fmt::format("at the start it is [{}, {}, {}], where finite numbers are needed", told(torque[0]),
                      told(torque[1]), told(torque[2])));
    }
    Eigen::Matrix3d const decay = inverse * formulas_->slope({q[0], q[1], q[2], q[3]}, t, {w[0], w[1], w[2]});
    fastest = std::max(fastest, std::sqrt(magnitude(change) / 2));
    if (is_finite(decay)) fastest = std::max(fastest, decay.norm());
  }
  return fastest;
}

double SceneTorque::pace(bodies::FreeState const& start, double until,
                         std::vector<std::string>& remarks) const {
  double const own = formulas_ ? pace_of_formulas(start, until) : 0;
  if (!of_potential_)
    return std::max(own, fastest_turn(inertia_, kinetic_energy(inertia_, start.body_momentum)));
  return std::max(own, std::visit(
                           [&](auto const& torque) {
                             if constexpr (std::is_same_v<std::decay_t<decltype(torque)>,
                                                          bodies::PotentialTorque<FormulaPotential>>)
                               return pace_of(torque, start, until, remarks);
                             else
                               return pace_of(torque, start);
                           },
                           *of_potential_));
}

long SceneTorque::steps_at_once() const {
  constexpr long most = 1 << 14, kicks = 6;
  long operations = 0;
  if (of_potential_)
    if (auto const* const formula = std::get_if<bodies::PotentialTorque<FormulaPotential>>(&*of_potential_))
      operations += static_cast<long>(formula->function().operations_of_slope()) + 1;
  // Two stages, and some ten iterations.
  if (formulas_) operations += 20 * (static_cast<long>(formulas_->operations()) + 10);
  return operations > 0 ? std::clamp(10'000'000 / (kicks * operations), 1L, most) : most;
}

}  // namespace actio::scene
