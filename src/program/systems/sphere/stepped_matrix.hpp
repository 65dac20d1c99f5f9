// A matrix that moves on by one kind of step: what the flows on the sphere and on the torus have in common.
#pragma once

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>
#include <vector>

#include "actio/vorticity/past_steps.hpp"
#include "actio/vorticity/step_setting.hpp"
#include "program/registry/simulation.hpp"
#include "program/systems/sphere/scheme.hpp"

namespace actio::scene {

/// A skew-Hermitian matrix in a checkpoint, of which half says the whole.
template <class Real>
void remember_matrix(CheckpointStream& stream, sphere::SkewHermitian<Real>& w, int n);

/// A matrix in steps, each of one substep or of several.
/// @tparam Step  `VorticityStep<Stream>` or `FastVorticityStep<Stream>`
/// @tparam Kind  of motion, what it derives from
template <class Step, class Kind>
class SteppedMatrix : public Kind {
 public:
  /// Makes the substeps of a step of some length. A fraction of a step has a scheme of its own at each of its
  /// places, which guesses from what was found there in the steps before: these are evenly spaced, as the
  /// guess needs it.
  using MakeSteps = std::function<std::vector<Step>(double step)>;

  /// From a state on.
  SteppedMatrix(sphere::SkewHermitian<> start, SphereScheme scheme, double step, MakeSteps make_steps)
      : scheme_(std::move(scheme)),
        make_steps_(std::move(make_steps)),
        step_(step),
        steps_(make_steps_(step)),
        w_(std::move(start)) {}

  /// So many steps.
  void advance(long count) override {
    ahead_.reset();
    for (long k = 0; k < count; ++k) {
      make_step(steps_, w_, step_);
      ++made_;
    }
  }
  /// Shows a state beyond the last step.
  void look_ahead(double time) override {
    ahead_.reset();
    if (time == 0) return;
    auto shorter = make_steps_(time);
    sphere::SkewHermitian<> w = w_;
    make_step(shorter, w, time);
    ahead_.emplace(std::move(w)), beyond_ = time;
  }
  /// Goes on with steps of another length.
  void change_step(double first, double step, long made) override {
    ahead_.reset();
    if (first > 0) {
      auto on_the_way = make_steps_(first);
      make_step(on_the_way, w_, first);
    }
    steps_ = make_steps_(step), step_ = step, made_ = made;
  }
  /// Saves, or restores, the matrix and what the steps guess from.
  void remember(CheckpointStream& stream) override {
    auto const n = size();
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

 protected:
  /// The steps are counted, and times are multiplied.
  double time() const { return static_cast<double>(made_) * step_ + (ahead_ ? beyond_ : 0); }
  /// What is stepped.
  sphere::SkewHermitian<> const& state() const { return ahead_ ? *ahead_ : w_; }

 private:
  int size() const { return static_cast<int>(w_.size()); }
  /// What a step guesses from.
  void remember_past(CheckpointStream& stream, typename Step::Past& past) const {
    int const n = size();
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

  SphereScheme scheme_;
  MakeSteps make_steps_;
  double step_;
  std::vector<Step> steps_;
  sphere::SkewHermitian<> w_;
  long made_ = 0;
  std::optional<sphere::SkewHermitian<>> ahead_;
  double beyond_ = 0;
};

}  // namespace actio::scene
