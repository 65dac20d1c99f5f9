// Motions by the discrete Euler-Poincare equations, step after step: what one step has found out about the equation serves the next.
//
// The functions `step_euler_poincare_right` and `step_euler_poincare_left` know of a motion what they are given, the last relative motion. Who takes many
// steps knows more: the momentum, which Ad* carries along (the discrete Lie-Poisson algorithm); the derivative of the equation, which changes
// little from step to step; and where the motion is going. The relative motions are the same, to rounding.
#pragma once

#include "actio/foundations/chord_iteration.hpp"
#include "actio/foundations/extrapolation.hpp"
#include "actio/reduction/discrete_lie_poisson.hpp"

namespace actio {

namespace detail {

/// Relative motions at equal steps: solves for the next, started where the last ones lead.
///
/// The sequence \f$\delta_k\f$ with \f$f_k = e^{\delta_k}f_{k-1}\f$ is as smooth as the motion, and small, so that no chart ends on the way.
template <ExponentialGroup G, Real S>
class FollowedSequence {
 public:
  /// The solution that comes after `f`.
  template <class Residual>
  Element<G, S> after(Residual const& residual, Element<G, S> const& f) {
    if constexpr (Plain<S>) {
      if (changes_.empty()) {
        auto const next = iteration_.solve(residual, f);
        changes_.push(iteration_.moved());
        return next;
      }
      // What is appended is the change to first order in what the extrapolation has missed.
      Velocity<G, S> const expected{f.group, changes_.next()};
      auto const next = iteration_.solve(residual, exp(expected) * f, f);
      Velocity<G, S> const missed{f.group, iteration_.moved()};
      changes_.push((expected + missed + bracket(missed, expected) / S(2)).coordinates);
      return next;
    } else {
      return solve_on_group(residual, f).value;
    }
  }
  Report const& report() const { return iteration_.report(); }
  auto const& iteration() const { return iteration_; }

 private:
  ChordIteration<G, S> iteration_;
  Extrapolation<Coordinates<G, S>> changes_;
};

}  // namespace detail

/// The motion of a left-invariant system, \ref euler_poincare_left solved step after step.
template <class F, ExponentialGroup G, Real S>
class EulerPoincareStepsLeft {
 public:
  EulerPoincareStepsLeft(F l, Element<G, S> const& f10) : l_(std::move(l)), f_(f10), taken_up_(right_differential(l_, f10)) {}

  void advance() {
    f_ = sequence_.after([&](auto const& f) { return left_differential(l_, f) - like(f, taken_up_); }, f_);
    taken_up_ = Ad_star(inverse(f_), taken_up_);
  }
  Element<G, S> const& relative_motion() const { return f_; }
  Report const& report() const { return sequence_.report(); }
  auto const& iteration() const { return sequence_.iteration(); }

 private:
  F l_;
  Element<G, S> f_;
  Momentum<G, S> taken_up_;
  detail::FollowedSequence<G, S> sequence_;
};

}  // namespace actio
