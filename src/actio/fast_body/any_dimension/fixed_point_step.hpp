// A step of the Moser-Veselov scheme on SO(n) by fixed-point iteration (an iteration is a sweep over the
// blocks of the matrices), and the compiled copies of it.
#pragma once

#include <utility>

#include "actio/fast_body/any_dimension/block_products.hpp"
#include "actio/fast_body/any_dimension/rotating_body.hpp"
#include "actio/fast_body/any_dimension/stopping_rule.hpp"

namespace actio::bodies::detail {

/// The parts of a step of one body under one scheme.
struct FixedPointStep {
  RotatingBody& body;
  SweptInertia inertia;
  StoppingRule rule;

  static constexpr int most_sweeps = 60;

  double* momentum() const { return body.half(RotatingBody::momentum_); }
  double* motion() const { return body.full(RotatingBody::motion_); }
  double* square() const { return body.half(body.formed_); }
  double* guess() const { return body.half(body.guess_); }
  double const* past(int k) const { return body.past(k); }

  template <int B>
  [[gnu::always_inline]] void square_motion(Blocked<B> const& shape) const {
    square_of(shape, motion(), square());
  }
  /// e from the square just formed, which becomes the guess.
  template <int B>
  [[gnu::always_inline]] void sweep_on(Blocked<B> const& shape) const {
    std::swap(body.formed_, body.guess_);
    relative_motion(shape, inertia, guess(), momentum(), motion());
  }

  /// Sweeps until the rule says so. Whether it did, and the branch is sure.
  template <int B>
  [[gnu::always_inline]] bool converge(Blocked<B> const& shape) const {
    double before = HUGE_VAL;
    body.solved_ = false;
    for (body.sweeps_ = 1; body.sweeps_ <= most_sweeps; ++body.sweeps_) {
      square_motion(shape);
      Defect const d = defect(shape, square(), guess());
      body.defect_ = d.change;
      if (!(d.square < 1e30)) return false;  // a NaN neither
      if (body.sweeps_ == 2) body.contraction_ = d.change / before;
      if (rule.done(d, before)) {
        if (rule.sweeps == Sweeps::beyond_rounding) sweep_on(shape), square_motion(shape), ++body.sweeps_;
        body.solved_ = true;
        return rule.on_branch_of_identity(d);
      }
      before = d.change;
      sweep_on(shape);
    }
    return false;
  }

  /// Attitude and momentum after the step, given its square, and e of the next.
  template <int B>
  [[gnu::always_inline]] void finish(Blocked<B> const& shape, bool with_attitude) const {
    if (with_attitude) {
      relative_motion(shape, inertia, square(), momentum(), motion());
      double *const attitude = body.full(RotatingBody::attitude_), *const product =
                                                                       body.full(RotatingBody::room_);
      product_of(shape, attitude, motion(), product);
      turn(shape, attitude, body.full(RotatingBody::attitude_rest_), product);
    }
    remember();
    double const* terms[RotatingBody::longest];
    for (int k = 0; k < body.continuation_->length; ++k) terms[k] = past(k);
    advance(shape, inertia, *body.continuation_, terms, momentum(), body.half(RotatingBody::momentum_rest_),
            guess(), motion());
  }

  /// The square just formed becomes the latest of the past; the oldest makes room.
  void remember() const;

  /// The shortest continuation among those that save the most squares, judged by what it would have made of
  /// the latest.
  void choose_extrapolation() const;
  /// The square of the norm of what the continuation of the past would have missed of the latest square, from
  /// a few thousand entries.
  double error_of(Weights const& w) const;

  /// Makes a body ready for steps of this scheme: nothing is remembered, e is made of the momentum alone.
  template <int B>
  [[gnu::always_inline]] void prepare(Blocked<B> const& shape) const {
    body.past_ = 0, body.contraction_ = 1;
    std::fill(guess(), guess() + body.half_size_, 0.0);
    relative_motion(shape, inertia, guess(), momentum(), motion());
  }
};

/// What is done with a body.
enum class Stage { prepare, square, finish, finish_with_attitude, step, step_with_attitude };

template <int B>
[[gnu::always_inline]] inline bool carry_out(FixedPointStep const& s, Stage stage, int n) {
  Blocked<B> const shape(n);
  if (stage == Stage::prepare) return s.prepare(shape), true;
  if (stage == Stage::square) return s.square_motion(shape), true;
  if (stage >= Stage::step && !s.converge(shape)) return false;
  s.finish(shape, stage == Stage::finish_with_attitude || stage == Stage::step_with_attitude);
  return true;
}
template <int B>
ACTIO_FOR_AVX2 bool carry_out_avx2(FixedPointStep const& s, Stage stage, int n) {
  return carry_out<B>(s, stage, n);
}
template <int B>
bool carry_out_plain(FixedPointStep const& s, Stage stage, int n) { return carry_out<B>(s, stage, n); }

/// The copy for this size and machine.
auto choose_step(int n, Machine machine) -> bool (*)(FixedPointStep const&, Stage, int);

}  // namespace actio::bodies::detail
