#include "program/systems/rods/motion.hpp"

#include <algorithm>
#include <cmath>

namespace actio::scene {
namespace {

double angle_between(rods::Four<double> const& p, rods::Four<double> const& q) {
  double minus = 0, plus = 0;
  for (std::size_t i = 0; i < 4; ++i)
    minus += (p[i] - q[i]) * (p[i] - q[i]), plus += (p[i] + q[i]) * (p[i] + q[i]);
  return 4 * std::atan2(std::sqrt(std::min(minus, plus)), std::sqrt(std::max(minus, plus)));
}

}  // namespace

RodMotion::RodMotion(RodScene const& scene, double step)
    : rod_(scene.with_step(step)), at_start_(rod_.momentum()), length_(scene.rest.length) {}

void RodMotion::advance(long count) {
  frame_.reset();
  rod_.step(count);
}

void RodMotion::look_ahead(double time) {
  frame_.reset();
  rod_.look_ahead(time);
}

void RodMotion::change_step(double first, double step, long made) {
  frame_.reset();
  rod_.change_step(first, step, made);
}

void RodMotion::remember(CheckpointStream& stream) {
  auto state = rod_.remember();
  stream(state);
  if (!stream.reading()) return;
  rod_.restore(state), frame_.reset();
}

rods::RodFrame const& RodMotion::frame() const {
  if (!frame_) frame_ = rod_.frame();
  return *frame_;
}

StateDistance RodMotion::distance(Motion const& other) const {
  auto const &here = frame(), &there = static_cast<RodMotion const&>(other).frame();
  StateDistance out;
  for (std::size_t k = 0; k < here.places.size(); ++k) {
    out.attitude = std::max(out.attitude, angle_between(here.attitudes[k], there.attitudes[k]));
    auto const &x = here.places[k], &y = there.places[k];
    out.momentum = std::max(out.momentum, std::hypot(x[0] - y[0], x[1] - y[1], x[2] - y[2]));
  }
  out.modulus = length_;
  return out;
}

}  // namespace actio::scene
