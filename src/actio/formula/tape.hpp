// A formula as a list of instructions, which is evaluated over every scalar of the library.
//
// One array holds the constants, the inputs and the results of the instructions one after another. The
// instructions are sorted into runs of one operation, each a plain loop, so that the machine decides once a
// run what to do. Constants are exact: over 50 digits 0.1 is a tenth to 50 digits, over the rationals it is
// 1/10.
#pragma once

#include <cstdint>
#include <vector>

#include "actio/formula/elementary.hpp"
#include "actio/formula/exact_ratio.hpp"
#include "actio/formula/operation.hpp"

namespace actio {

/// Functions of several numbers as instructions. A \ref TapeBuilder makes them.
struct Tape {
  /// The places of the operands in the array; where there is one operand, `b` is not looked at.
  struct Instruction {
    std::uint32_t a = 0;  ///< the first
    std::uint32_t b = 0;  ///< the second
  };
  /// Instructions in a row that do the same.
  struct Run {
    Operation operation;  ///< what they do
    std::uint32_t count;  ///< how many they are
  };

  int inputs = 0;                         ///< how many numbers it is a function of
  std::vector<ExactRatio> numbers;        ///< its constants
  std::vector<Run> constant_runs;         ///< what makes further constants of them, as log(2)
  std::vector<Run> runs;                  ///< what a call does
  std::vector<Instruction> instructions;  ///< of the constant runs and then of the others
  std::vector<double> constants;          ///< numbers and further constants over double
  std::vector<std::uint32_t> outputs;     ///< where the values of the functions are

  /// How many functions it evaluates.
  int size() const { return static_cast<int>(outputs.size()); }
  /// Length of the array: numbers, further constants, inputs, results.
  std::size_t places() const {
    return numbers.size() + static_cast<std::size_t>(inputs) + instructions.size();
  }
  /// Whether a function is a constant.
  bool is_constant(int output) const { return outputs[static_cast<std::size_t>(output)] < constants.size(); }
  /// Whether one of the functions depends on an input.
  bool depends_on(int input) const;

  /// Evaluates all functions. Outside of the domain of a root, a logarithm or a power their values are NaNs.
  /// @param x     the inputs
  /// @param y     the values, as many as the tape has outputs
  /// @param work  memory: it grows to \ref places where it is shorter, and nothing is allocated where it is
  ///              not; one for each thread, of use to any number of tapes
  /// @throws NotInThisField  over the rationals, where a function leaves them
  template <class S>
  void operator()(S const* x, S* y, std::vector<S>& work) const;

 private:
  template <class S>
  void load_constants(S* place) const;
  template <class S>
  static S* carry_out(std::vector<Run> const& these, Instruction const* instruction, S const* place,
                      S* result);
};

template <class S>
S* Tape::carry_out(std::vector<Run> const& these, Instruction const* i, S const* w, S* r) {
  for (Run const& run : these) {
    Instruction const* const end = i + run.count;
    switch (run.operation) {
      case Operation::add:
        for (; i != end; ++i) *r++ = w[i->a] + w[i->b];
        break;
      case Operation::subtract:
        for (; i != end; ++i) *r++ = w[i->a] - w[i->b];
        break;
      case Operation::multiply:
        for (; i != end; ++i) *r++ = w[i->a] * w[i->b];
        break;
      case Operation::divide:
        for (; i != end; ++i) *r++ = w[i->a] / w[i->b];
        break;
      case Operation::negate:
        for (; i != end; ++i) *r++ = -w[i->a];
        break;
      case Operation::power:
        for (; i != end; ++i) *r++ = power(w[i->a], w[i->b]);
        break;
      case Operation::atan2:
        for (; i != end; ++i) *r++ = angle_of(w[i->a], w[i->b]);
        break;
      case Operation::hypot:
        for (; i != end; ++i) *r++ = hypotenuse(w[i->a], w[i->b]);
        break;
      case Operation::pi:
        for (; i != end; ++i) *r++ = half_turn<S>();
        break;
      default:
        if (joins_two(run.operation))
          for (; i != end; ++i) *r++ = kinked(run.operation, w[i->a], w[i->b]);
        else
          for (; i != end; ++i) *r++ = elementary(run.operation, w[i->a]);
    }
  }
  return r;
}

template <class S>
void Tape::load_constants(S* place) const {
  if constexpr (std::same_as<Base<S>, double>) {
    for (double c : constants) *place++ = S(c);
  } else {
    S* r = place;
    for (ExactRatio const& n : numbers) *r++ = ratio<S>(n.above, n.below);
    carry_out(constant_runs, instructions.data(), place, r);
  }
}

template <class S>
void Tape::operator()(S const* x, S* y, std::vector<S>& work) const {
  if (work.size() < places()) work.resize(places());
  S* const w = work.data();
  load_constants(w);
  S* r = w + constants.size();
  for (int i = 0; i < inputs; ++i) *r++ = x[i];
  carry_out(runs, instructions.data() + (constants.size() - numbers.size()), w, r);
  for (std::uint32_t output : outputs) *y++ = w[output];
}

}  // namespace actio
