#include "actio/formula/tape_derivatives.hpp"

namespace actio {

std::vector<TapeBuilder::Entry> replay(Tape const& tape, TapeBuilder& b,
                                       TapeBuilder::Entry (TapeBuilder::*record)(Operation,
                                                                                 TapeBuilder::Entry,
                                                                                 TapeBuilder::Entry)) {
  std::vector<TapeBuilder::Entry> at;  // of each place
  at.reserve(tape.places());
  auto instruction = tape.instructions.begin();
  auto const carry_out = [&](std::vector<Tape::Run> const& runs) {
    for (Tape::Run const& run : runs)
      for (std::uint32_t i = 0; i < run.count; ++i, ++instruction)
        at.push_back(run.operation == Operation::pi
                         ? b.pi()
                         : (b.*record)(run.operation, at[instruction->a], at[instruction->b]));
  };
  for (ExactRatio const& n : tape.numbers) at.push_back(b.number(n));
  carry_out(tape.constant_runs);
  for (std::size_t i = 0; i < at.size(); ++i) b.set_value(at[i], tape.constants[i]);
  for (int i = 0; i < tape.inputs; ++i) at.push_back(static_cast<TapeBuilder::Entry>(i));
  carry_out(tape.runs);
  std::vector<TapeBuilder::Entry> outputs;
  for (std::uint32_t output : tape.outputs) outputs.push_back(at[output]);
  return outputs;
}

Tape joined(std::vector<Tape> const& tapes) {
  TapeBuilder b(tapes.at(0).inputs);
  std::vector<TapeBuilder::Entry> outputs;
  for (Tape const& tape : tapes)
    for (TapeBuilder::Entry const output : replay(tape, b, &TapeBuilder::as_written))
      outputs.push_back(output);
  return b.tape(outputs);
}

namespace detail {

ReverseMode::ReverseMode(TapeBuilder& b, std::vector<int> const& wrt) : b_(b), wrt_(wrt) {
  depends_.assign(static_cast<std::size_t>(b.inputs()), false);
  for (int i : wrt) {
    if (i < 0 || i >= b.inputs())
      throw OutsideDomain("the derivative of a tape", "an input is needed, numbered from 0", i, b.inputs());
    depends_[static_cast<std::size_t>(i)] = true;
  }
}

std::vector<ReverseMode::Entry> ReverseMode::gradient(Entry f, std::size_t first) {
  note_dependence(f);
  rate_.assign(f + 1, std::nullopt);
  rate_[f] = b_.number(1);
  for (Entry e = f + 1; e-- > 0;)
    if (rate_[e] && depends_[e] && b_.operation(e) != Operation::input) pass_on(e, Term(b_, *rate_[e]));
  std::vector<Entry> all;
  for (std::size_t k = first; k < wrt_.size(); ++k) {
    auto const i = static_cast<Entry>(wrt_[k]);
    all.push_back(i <= f && rate_[i] ? *rate_[i] : b_.number(0));
  }
  return all;
}

void ReverseMode::pass_on(Entry e, Term const& r) {
  Entry const a = b_.first(e), c = b_.second(e);
  Term const f(b_, e), x(b_, a), y(b_, c);
  switch (b_.operation(e)) {
    case Operation::add:
      return receive(a, r), receive(c, r);
    case Operation::subtract:
      return receive(a, r), lose(c, r);
    case Operation::negate:
      return lose(a, r);
    case Operation::multiply:
      return receive(a, r * y), receive(c, r * x);
    case Operation::divide:
      return receive(a, r / y), lose(c, r / y * f);
    case Operation::power:
      return receive(a, r * (y * power(x, y - 1)));
    case Operation::hypot:
      return receive(a, r / f * x), receive(c, r / f * y);
    case Operation::atan2: {
      Term const s = r / (x * x + y * y);
      return receive(a, s * y), lose(c, s * x);
    }
    default:
      return receive(a, r * slope(b_.operation(e), x, f));
  }
}

}  // namespace detail

Tape with_gradient(Tape const& f, std::vector<int> const& wrt) {
  TapeBuilder b(f.inputs, detail::most_with_derivatives);
  std::vector<TapeBuilder::Entry> outputs{replay(f, b).at(0)};
  auto const gradient = detail::ReverseMode(b, wrt).gradient(outputs[0]);
  outputs.insert(outputs.end(), gradient.begin(), gradient.end());
  return b.tape(outputs);
}

Tape with_hessian(Tape const& f, std::vector<int> const& wrt) {
  TapeBuilder b(f.inputs, detail::most_with_derivatives);
  std::vector<TapeBuilder::Entry> outputs{replay(f, b).at(0)};
  detail::ReverseMode derivatives(b, wrt);
  auto const gradient = derivatives.gradient(outputs[0]);
  outputs.insert(outputs.end(), gradient.begin(), gradient.end());
  for (std::size_t i = 0; i < wrt.size(); ++i) {
    auto const row = derivatives.gradient(gradient[i], i);
    outputs.insert(outputs.end(), row.begin(), row.end());
  }
  return b.tape(outputs);
}

}  // namespace actio
