#include "actio/fast_body/any_dimension/fixed_point_step.hpp"

namespace actio::bodies {

namespace detail {

void FixedPointStep::remember() const {
  body.latest_ = body.latest_ == 0 ? RotatingBody::longest - 1 : body.latest_ - 1;
  std::swap(body.formed_, body.ring_[static_cast<std::size_t>(body.latest_)]);
  ++body.steps_;
  bool const growing = body.past_ < RotatingBody::longest;
  if (growing) ++body.past_;
  bool const worse = body.squares() > body.expected_ && body.steps_ > body.chosen_ + 32;
  if (growing || worse || body.steps_ > body.chosen_ + 1024) choose_extrapolation();
}

void FixedPointStep::choose_extrapolation() const {
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

double FixedPointStep::error_of(Weights const& w) const {
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

auto choose_step(int n, Machine machine) -> bool (*)(FixedPointStep const&, Stage, int) {
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

}  // namespace detail

}  // namespace actio::bodies
