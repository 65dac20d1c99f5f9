#include <Eigen/Core>

#include "program/systems/two_bodies/motion.hpp"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace actio::scene {
namespace {

constexpr double full = 2 * std::numbers::pi;

Eigen::Vector3d vector(std::array<double, 3> const& v) { return Eigen::Vector3d(v.data()); }
std::array<double, 3> three(Eigen::Vector3d const& v) { return {v[0], v[1], v[2]}; }

/// The cubic on [0, 1] with these values and slopes at the ends.
double cubic(double t, double from, double to, double slope_from, double slope_to) {
  double const s = 1 - t;
  return s * s * ((1 + 2 * t) * from + t * slope_from) + t * t * ((1 + 2 * s) * to - s * slope_to);
}
/// Where such a cubic is least; its slope is negative at 0 and not at 1.
double least_of_cubic(double from, double to, double slope_from, double slope_to) {
  double const b = 6 * (to - from) - 4 * slope_from - 2 * slope_to,
               a = 3 * (slope_from + slope_to) - 6 * (to - from);
  return -2 * slope_from / (b + std::sqrt(std::max(0.0, b * b - 4 * a * slope_from)));
}

double angle_between(Element<SU2, double> const& p, Element<SU2, double> const& q) {
  double const minus = (p.value - q.value).norm(), plus = (p.value + q.value).norm();
  return 4 * std::atan2(std::min(minus, plus), std::max(minus, plus));
}

}  // namespace

OrbitWay::OrbitWay(bodies::TwoBodyState const& start, double reduced_mass) : reduced_mass_(reduced_mass) {
  Eigen::Vector3d const normal = start.position.cross(start.momentum).normalized();
  along_ = three(start.position.normalized()), across_ = three(normal.cross(vector(along_)));
  last_ = seen_from(start, 0);
}

OrbitWay::Point OrbitWay::seen_from(bodies::TwoBodyState const& state, double time) const {
  Eigen::Vector3d const &X = state.position, V = state.momentum / reduced_mass_;
  double const x = vector(along_).dot(X), y = vector(across_).dot(X),
               turned = std::remainder(std::atan2(y, x) - last_.angle, full);
  return {time, X.squaredNorm(), X.dot(V), last_.angle + turned,
          (x * vector(across_).dot(V) - y * vector(along_).dot(V)) / (x * x + y * y)};
}

void OrbitWay::see(bodies::TwoBodyState const& state, double time) {
  Point const next = seen_from(state, time);
  double const h = time - last_.time;
  if (last_.rising < 0 && next.rising >= 0) {
    double const at = least_of_cubic(last_.square, next.square, 2 * h * last_.rising, 2 * h * next.rising),
                 t = last_.time + at * h,
                 longitude =
                     cubic(at, last_.angle, next.angle, h * last_.rate, h * next.rate) - full * passed_;
    ++passed_;
    double const dt = t - mean_time_, df = longitude - mean_longitude_;
    mean_time_ += dt / passed_, mean_longitude_ += df / passed_;
    spread_ += dt * (t - mean_time_), product_ += dt * (longitude - mean_longitude_);
  }
  last_ = next;
}

double OrbitWay::mean_period() const {
  return last_.time == 0 ? full / last_.rate : full * last_.time / last_.angle;
}

void TangentSoFar::follow(Eigen::Matrix<double, 18, 18> const& by) {
  map = (by * map).eval();
  along = (by * along.cwiseProduct(unit)).cwiseQuotient(unit).eval();
  growth += std::log(along.norm());
  along.normalize();
}

PairMotion::PairMotion(PairScene const& scene, double step, Follows follows)
    : follows_(follows),
      state_{bodies::TwoBodies(scene.primary, scene.secondary, scene.start,
                               [&] {
                                 auto options = scene.options;
                                 options.step = step;
                                 return options;
                               }()),
             {},
             {}} {
  auto const& pair = state_.pair;
  if (follows.way) state_.way = OrbitWay(scene.start, pair.reduced_mass());
  if (!follows.tangent) return;
  state_.tangent.unit = pair.tangent_units(), state_.tangent.along.setConstant(1 / std::sqrt(18.0));
}

void PairMotion::move(State& state, long count) const {
  // Where the bodies come too near the piece is refused as a whole; a tangent vector loses no digits in one.
  long const most = follows_.way ? 1 : 4;
  for (long left = count; left > 0;) {
    long const next = std::min(left, most);
    Eigen::Matrix<double, 18, 18> map;
    if (follows_.tangent) map = state.pair.tangent_map(next);
    state.pair.step(next), left -= next;
    if (follows_.tangent) state.tangent.follow(map);
    if (follows_.way) state.way.see(state.pair.state(), state.pair.time());
  }
}

void PairMotion::advance(long count) {
  ahead_.reset();
  move(state_, count);
}

bodies::TwoBodies PairMotion::with_step(bodies::TwoBodies const& pair, double step) {
  auto options = pair.options();
  options.step = step, options.start = pair.time();
  return {pair.first(), pair.second(), pair.state(), options};
}

void PairMotion::look_ahead(double time) {
  ahead_.reset();
  if (time == 0) return;
  State ahead{with_step(state_.pair, time), state_.way, state_.tangent};
  move(ahead, 1);
  ahead_.emplace(std::move(ahead));
}

void PairMotion::change_step(double first, double step, long made) {
  look_ahead(first);
  State next{with_step(pair(), step), way(), tangent()};
  auto options = next.pair.options();
  options.start = 0;
  next.pair = bodies::TwoBodies(next.pair.first(), next.pair.second(), next.pair.state(), options);
  auto counted = [made](auto&, int&, int&, long& steps) { steps = made; };
  next.pair.remember(counted);
  ahead_.reset();
  state_ = std::move(next);
}

void PairMotion::remember(CheckpointStream& stream) {
  state_.pair.remember(stream);
  if (follows_.way) stream(state_.way);
  if (!follows_.tangent) return;
  std::span<double> map(state_.tangent.map.data(), 18 * 18), along(state_.tangent.along.data(), 18);
  stream(map, along, state_.tangent.growth);
}

StateDistance PairMotion::distance(Motion const& other) const {
  auto const here = pair().state(), there = static_cast<PairMotion const&>(other).pair().state();
  StateDistance out;
  out.attitude = std::max(angle_between(here.first.attitude, there.first.attitude),
                          angle_between(here.second.attitude, there.second.attitude));
  out.momentum = (here.position - there.position).norm();
  out.modulus = here.position.norm();
  return out;
}

}  // namespace actio::scene
