// The force at the two ends of a step of the natural chart.
#pragma once

#include "actio/any_group/reduced_system.hpp"

namespace actio::systems {

/// The force of a system at both ends of a step, at one scalar, with its work space.
template <class S>
class StepForce {
 public:
  /// Of a system that outlives it.
  explicit StepForce(ReducedSystem const& system) : system_(system) {
    if (!system.force) return;
    inputs_.resize(static_cast<std::size_t>(system.force->components.inputs));
    before.resize(static_cast<std::size_t>(system.dimension())), after = before;
    same_ = system.force->is_same_at_both_ends(system.dimension());
  }

  std::vector<S> before,  ///< at the start, energy; empty where there is none
      after;              ///< at the end

  /// When the step starts.
  /// @param frame  of the point there (`ReducedPoint`), for a force in components of the other side
  /// @throws OutsideDomain  where there is such a force and no frame
  void begin_at(S const& time, std::vector<double> const& frame) {
    time_ = time;
    if (!system_.force || !system_.force->across) return;
    if (frame.size() != before.size() * before.size())
      throw OutsideDomain("natural chart",
                          "a force in components of the other side needs the frame of the point; its numbers",
                          int(frame.size()), int(before.size() * before.size()));
    frame_ = frame;
  }

  /// Both forces, with the inputs of the middle of the step.
  /// @param a, b   the vectors at the start and at the end
  /// @param p      the momentum that is the mean over the step
  /// @param carry  carries a covector that is constant on the other side from the start to the end, in place
  template <class Carry>
  void evaluate(S const& h, std::vector<S> const& v, std::vector<S> const& a, std::vector<S> const& b,
                std::vector<S> const& p, Carry const& carry) {
    auto const& force = *system_.force;
    auto held = inputs_.end() - static_cast<std::ptrdiff_t>(force.held.size());
    double const middle = to_double(base_value(time_)) + to_double(base_value(h)) / 2;
    for (auto const& input : force.held) *held++ = S(input(middle));
    set_inputs(time_, v, a, p);
    force.components(inputs_.data(), before.data(), work_);
    if (force.across) add_across(before);
    if (same_ && !force.across) {
      after = before;
      return;
    }
    set_inputs(time_ + h, v, b, p);
    std::fill(after.begin(), after.end(), S(0));
    if (force.across) add_across(after), carry(after.data());
    own_.resize(after.size());
    force.components(inputs_.data(), own_.data(), work_);
    for (std::size_t i = 0; i < after.size(); ++i) after[i] += own_[i];
  }

 private:
  void set_inputs(S const& t, std::vector<S> const& v, std::vector<S> const& a, std::vector<S> const& p) {
    auto next = std::copy(v.begin(), v.end(), inputs_.begin());
    next = std::copy(a.begin(), a.end(), next);
    *std::copy(p.begin(), p.end(), next) = t;
  }
  /// Adds the force in components of the other side, moved to this one by the frame of the start.
  void add_across(std::vector<S>& sum) {
    auto const d = sum.size();
    other_.resize(d);
    (*system_.force->across)(inputs_.data(), other_.data(), work_);
    for (std::size_t c = 0; c < d; ++c)
      for (std::size_t i = 0; i < d; ++i) sum[i] += other_[c] * S(frame_[c * d + i]);
  }

  ReducedSystem const& system_;
  std::vector<S> inputs_, own_, other_, work_;
  std::vector<double> frame_;
  S time_{0};
  bool same_ = false;
};

}  // namespace actio::systems
