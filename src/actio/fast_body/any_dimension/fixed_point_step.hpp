// A step of the Moser-Veselov scheme on SO(n) by fixed-point iteration (an iteration is a sweep over the
// blocks of the matrices), and the compiled copies of it.
#pragma once

#include <utility>

#include "actio/fast_body/any_dimension/block_products.hpp"
#include "actio/fast_body/any_dimension/rotating_body.hpp"
#include "actio/fast_body/any_dimension/stopping_rule.hpp"

namespace actio::detail {

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
  void remember() const {
    body.latest_ = body.latest_ == 0 ? RotatingBody::longest - 1 : body.latest_ - 1;
    std::swap(body.formed_, body.ring_[static_cast<std::size_t>(body.latest_)]);
    ++body.steps_;
    bool const growing = body.past_ < RotatingBody::longest;
    if (growing) ++body.past_;
    bool const worse = body.squares() > body.expected_ && body.steps_ > body.chosen_ + 32;
    if (growing || worse || body.steps_ > body.chosen_ + 1024) choose_extrapolation();
  }

  /// The shortest continuation among those that save the most squares, judged by what it would have made of
  /// the latest.
  void choose_extrapolation() const {
    Defect const d = defect(body.shape_, past(0), past(0));
    double const q2 = std::min(rule.contraction(d), body.contraction_);
    body.continuation_ = &all_extrapolations().front();
    body.chosen_ = body.steps_, body.expected_ = 99;
    for (Weights const& w : all_extrapolations()) {
      if (w.length >= body.past_) break;
      int const count = rule.squares_needed(error_of(w), d, q2, w.amplification);
      if (count < body.expected_) body.expected_ = count, body.continuation_ = &w;
    }
  }
  /// The square of the norm of what the continuation of the past would have missed of the latest square, from
  /// a few thousand entries.
  double error_of(Weights const& w) const {
    int const size = static_cast<int>(body.half_size_), apart = 1 + size / 4096;
    double sum = 0;
    for (int block = 0; block < size; block += 16 * apart)
      for (int at = block; at < block + 16; ++at) {
        double d = past(0)[at];
        for (int a = 0; a < w.length; ++a) d -= w.weight[static_cast<std::size_t>(a)] * past(a + 1)[at];
        sum += d * d;
      }
    return 2.0 * apart * sum;
  }

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
inline auto choose_step(int n, Machine machine) -> bool (*)(FixedPointStep const&, Stage, int) {
  bool const avx2 = machine == Machine::avx2;
  switch ((n + 3) / 4) {
    case 1:
      return avx2 ? &carry_out_avx2<1> : &carry_out_plain<1>;
    case 2:
      return avx2 ? &carry_out_avx2<2> : &carry_out_plain<2>;
    case 4:
      return avx2 ? &carry_out_avx2<4> : &carry_out_plain<4>;
    default:
      return avx2 ? &carry_out_avx2<0> : &carry_out_plain<0>;
  }
}

}  // namespace actio::detail
