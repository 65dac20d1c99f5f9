// A flow on the sphere by one kind of step: the motion that a scene runs.
#pragma once

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "actio/quantized_sphere/sphere_invariants.hpp"
#include "program/systems/sphere/steps.hpp"

namespace actio::scene {

/// A skew-Hermitian matrix in a checkpoint, of which half says the whole.
template <class Real>
void remember_matrix(CheckpointStream& stream, sphere::SkewHermitian<Real>& w, int n);

/// A flow in steps, each of one substep or of several.
/// @tparam Step    `VorticityStep<Stream>` or `FastVorticityStep<Stream>`
/// @tparam Stream  that of the Hamiltonian of the flow
template <class Step, class Stream>
class SteppedVorticity : public VorticityMotion {
 public:
  /// From the start of the flow.
  SteppedVorticity(std::shared_ptr<SphereFlow const> flow, SphereScheme scheme, double step)
      : flow_(std::move(flow)),
        scheme_(std::move(scheme)),
        step_(step),
        steps_(substeps(step)),
        w_(flow_->first_state()) {}

  void advance(long count) override {
    ahead_.reset();
    for (long k = 0; k < count; ++k) {
      make_step(steps_, w_, step_);
      ++made_;
    }
  }
  void look_ahead(double time) override {
    ahead_.reset();
    if (time == 0) return;
    auto shorter = substeps(time);
    sphere::SkewHermitian<> w = w_;
    make_step(shorter, w, time);
    ahead_.emplace(std::move(w)), beyond_ = time;
  }
  void change_step(double first, double step, long made) override {
    ahead_.reset();
    if (first > 0) {
      auto on_the_way = substeps(first);
      make_step(on_the_way, w_, first);
    }
    steps_ = substeps(step), step_ = step, made_ = made;
  }
  void remember(CheckpointStream& stream) override {
    auto const n = flow_->sphere.n;
    stream(made_);
    remember_matrix(stream, w_, n);
    for (auto& step : steps_) {
      auto past = step.past();
      auto size = static_cast<long>(past.size());
      stream(size);
      if (stream.reading()) past.resize(static_cast<std::size_t>(std::clamp(size, 0L, 64L)));
      for (auto& one : past) remember_past(stream, one);
      if (stream.reading()) step.go_on_from(std::move(past));
    }
  }

  sphere::SkewHermitian<> vorticity_at_output() const override {
    sphere::TurningFrame const& frame = flow_->frame;
    double const t = time(), back = flow_->turning_back();
    if (flow_->apart.is_there()) {
      auto const& apart = flow_->apart;
      sphere::SkewHermitian<> w = about_pole(frame.rate * t, state());
      if (apart.upright.angle() != 0) w = tilt()(-apart.upright.angle(), w);
      w = about_pole(-back * t, w);
      add_function(w, Eigen::AngleAxisd(-back * t, Eigen::Vector3d::UnitZ()) * apart.relative);
      return w;
    }
    sphere::SkewHermitian<> w;
    if (frame.axis[0] == 0 && frame.axis[1] == 0) {
      w = about_pole((frame.rate * frame.axis[2] - back) * t, state());
    } else {
      if (!about_axis_) about_axis_.emplace(flow_->sphere, frame.axis);
      w = about_pole(-back * t, (*about_axis_)(frame.rate * t, state()));
    }
    add_function(w, -2 * flow_->rotation * Eigen::Vector3d::UnitZ());
    return w;
  }
  sphere::SkewHermitian<> vorticity_but_for_rotation() const override {
    sphere::SkewHermitian<> w = state();
    if (flow_->apart.is_there())
      add_function(w, into_frame() * (flow_->apart.upright * flow_->apart.relative));
    else if (flow_->rotation != 0)
      add_function(w, into_frame() * (-2 * flow_->rotation * Eigen::Vector3d::UnitZ()));
    return w;
  }
  sphere::SkewHermitian<> absolute_vorticity() const override {
    sphere::SkewHermitian<> w = state();
    add_function(w, flow_->apart.background.vorticity * Eigen::Vector3d::UnitZ());
    return w;
  }
  Eigen::Vector3d angular_momentum() const override {
    Eigen::Vector3d const of_state = into_frame().inverse() * sphere::sphere_momentum(state());
    if (!flow_->apart.is_there()) return of_state;
    // The integral of the square of a coordinate is 4 pi/3.
    return flow_->apart.upright.inverse() * of_state +
           4 * M_PI / 3 * (flow_->apart.relative + 2 * flow_->rotation * Eigen::Vector3d::UnitZ());
  }

 private:
  /// A fraction of a step has a scheme of its own at each of its places, which guesses from what was found
  /// there in the steps before: these are evenly spaced, as the guess needs it.
  std::vector<Step> substeps(double step) const {
    std::vector<Step> out;
    out.reserve(scheme_.fractions.size());
    for (double const fraction : scheme_.fractions) {
      auto const& stream = flow_->stream.template as<Stream>();
      if constexpr (requires(Step one) { one.half_change(); })
        out.emplace_back(stream, scheme_.conserved, fraction * step, flow_->frame, flow_->products,
                         flow_->apart.background);
      else
        out.emplace_back(stream, scheme_.conserved, fraction * step, flow_->frame, flow_->products);
    }
    return out;
  }
  /// What a step guesses from.
  void remember_past(CheckpointStream& stream, typename Step::Past& past) const {
    int const n = flow_->sphere.n;
    std::span<double> factors(past.factors.data(), 4);
    if constexpr (requires { past.half_change; }) {
      remember_matrix(stream, past.increment, n);
      if (scheme_.conserved != sphere::Conserved::lie_poisson) remember_matrix(stream, past.half_change, n);
      stream(factors);
    } else {
      for (auto* half : {&past.displacement, &past.increment})
        for (auto* part : {&half->real, &half->imaginary}) {
          if (stream.reading()) part->resize(sphere::LowerHalf::count(n));
          std::span<double> numbers(part->data(), static_cast<std::size_t>(part->size()));
          stream(numbers);
        }
      stream(factors), stream(past.guess_error), stream(past.wait), stream(past.radius), stream(past.age);
    }
  }

  /// The steps are counted, and times are multiplied.
  double time() const { return static_cast<double>(made_) * step_ + (ahead_ ? beyond_ : 0); }
  sphere::SkewHermitian<> about_pole(double angle, sphere::SkewHermitian<> const& w) const {
    return sphere::Turning(flow_->sphere, Eigen::Vector3d::UnitZ())(angle, w);
  }
  /// Adds \f$r\cdot x\f$.
  void add_function(sphere::SkewHermitian<>& w, Eigen::Vector3d const& r) const {
    sphere::add_spin(flow_->sphere, flow_->sphere.hbar() * r, w);
  }
  /// What is stepped.
  sphere::SkewHermitian<> const& state() const { return ahead_ ? *ahead_ : w_; }
  /// From axes that do not turn to those of the frame.
  Eigen::AngleAxisd into_frame() const { return {-flow_->frame.rate * time(), flow_->frame.axis}; }
  /// About the axis about which the axis of the frame was put upright.
  sphere::Turning const& tilt() const {
    if (!about_axis_) about_axis_.emplace(flow_->sphere, flow_->apart.upright.axis());
    return *about_axis_;
  }

  /// Where a substep cannot be made, the vorticity is as it was.
  void make_step(std::vector<Step>& steps, sphere::SkewHermitian<>& w, double length) const {
    if (steps.size() == 1) {
      steps.front().advance(w);
      return;
    }
    sphere::SkewHermitian<> const before = w;
    try {
      for (auto& step : steps) step.advance(w);
    } catch (sphere::NotContracting const& error) {
      w = before;
      throw sphere::NotContracting(length, std::copysign(error.largest / scheme_.longest(), length));
    }
  }

  std::shared_ptr<SphereFlow const> flow_;
  SphereScheme scheme_;
  double step_;
  std::vector<Step> steps_;
  sphere::SkewHermitian<> w_;
  long made_ = 0;
  std::optional<sphere::SkewHermitian<>> ahead_;
  double beyond_ = 0;
  mutable std::optional<sphere::Turning> about_axis_;
};

}  // namespace actio::scene
