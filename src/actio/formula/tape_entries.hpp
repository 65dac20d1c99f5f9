// What is recorded of a formula: inputs, constants and operations, each of them once.
#pragma once

#include <cstdint>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

#include "actio/formula/elementary.hpp"
#include "actio/formula/exact_ratio.hpp"
#include "actio/formula/operation.hpp"

namespace actio {

/// Entries: the inputs, which are 0, 1, ..., constants and the results of operations, each after its
/// operands. What was recorded before is found again.
class TapeEntries {
 public:
  using Entry = std::uint32_t;  ///< which entry

  /// The most entries that a formula takes.
  static constexpr std::size_t most_instructions = 100000;

  /// @param inputs  how many numbers the functions depend on
  /// @param most    how many further entries may be made, less than \f$2^{27}\f$
  explicit TapeEntries(int inputs, std::size_t most = most_instructions)
      : inputs_(inputs), most_(most + static_cast<std::size_t>(inputs)) {
    for (int i = 0; i < inputs; ++i)
      entries_.push_back({Operation::input, false, static_cast<Entry>(i), static_cast<Entry>(i), 0.0});
  }

  /// How many inputs there are.
  int inputs() const { return inputs_; }
  /// The input i.
  Entry input(int i) const { return static_cast<Entry>(i); }
  /// How many entries there are.
  Entry size() const { return static_cast<Entry>(entries_.size()); }
  /// What an entry is.
  Operation operation(Entry e) const { return entries_[e].operation; }
  /// The first operand of an operation.
  Entry first(Entry e) const { return entries_[e].a; }
  /// The second operand of an operation; the first again where it has one.
  Entry second(Entry e) const { return entries_[e].b; }
  /// Whether an entry depends on no input.
  bool is_constant(Entry e) const { return entries_[e].constant; }
  /// The value of a constant over double.
  double value(Entry e) const { return entries_[e].value; }
  /// The ratio that an entry is; nothing where it is none.
  ExactRatio const* ratio_of(Entry e) const {
    return operation(e) == Operation::number ? &numbers_[first(e)] : nullptr;
  }
  /// Whether an entry is this whole number.
  bool is(Entry e, int n) const { return ratio_of(e) && ratio_of(e)->is(n); }
  /// Says what a constant is over double, where that is known better than from its operands.
  void set_value(Entry constant, double value) { entries_[constant].value = value; }

  /// A ratio of 64-bit integers.
  /// @throws Error  here and below where no further entry may be made
  Entry number(ExactRatio const& x);
  /// A whole number.
  Entry number(int n) { return number(ExactRatio{n, 1}); }
  /// \f$\pi\f$.
  Entry pi();

 protected:
  /// An operation as it stands.
  Entry entry(Operation operation, Entry a, Entry b);
  /// An operation with one operand, as it stands.
  Entry entry(Operation operation, Entry a) { return entry(operation, a, a); }

 private:
  struct Recorded {
    Operation operation;
    bool constant;
    Entry a, b;    // of an input or a number, which one
    double value;  // of a constant
  };
  struct HashRatio {
    std::size_t operator()(ExactRatio const& x) const {
      return static_cast<std::size_t>(x.above) * 0x9E3779B97F4A7C15u + static_cast<std::size_t>(x.below);
    }
  };
  Entry make(Recorded const& recorded);
  double value_of(Operation operation, double x, double y) const;

  int inputs_;
  std::size_t most_;
  std::vector<Recorded> entries_;
  std::vector<ExactRatio> numbers_;
  std::unordered_map<std::uint64_t, Entry> found_;
  std::unordered_map<ExactRatio, Entry, HashRatio> found_numbers_;
};

inline TapeEntries::Entry TapeEntries::make(Recorded const& recorded) {
  if (entries_.size() >= most_)
    throw Error("a formula with its derivatives takes at most " +
                std::to_string(most_ - static_cast<std::size_t>(inputs_)) +
                " instructions, and this one takes more; define its common parts once");
  entries_.push_back(recorded);
  return size() - 1;
}

inline TapeEntries::Entry TapeEntries::number(ExactRatio const& x) {
  auto const known = found_numbers_.find(x);
  if (known != found_numbers_.end()) return known->second;
  auto const which = static_cast<Entry>(numbers_.size());
  numbers_.push_back(x);
  return found_numbers_[x] = make({Operation::number, true, which, which, to_double(x)});
}

inline TapeEntries::Entry TapeEntries::pi() {
  std::uint64_t const key = static_cast<std::uint64_t>(Operation::pi) << 56;
  auto const known = found_.find(key);
  if (known != found_.end()) return known->second;
  return found_[key] = make({Operation::pi, true, 0, 0, half_turn<double>()});
}

inline double TapeEntries::value_of(Operation operation, double x, double y) const {
  switch (operation) {
    case Operation::add:
      return x + y;
    case Operation::subtract:
      return x - y;
    case Operation::multiply:
      return x * y;
    case Operation::divide:
      return x / y;
    case Operation::negate:
      return -x;
    case Operation::power:
      return power(x, y);
    case Operation::atan2:
      return angle_of(x, y);
    case Operation::hypot:
      return hypotenuse(x, y);
    default:
      return elementary(operation, x);
  }
}

inline TapeEntries::Entry TapeEntries::entry(Operation operation, Entry a, Entry b) {
  // Sums and products in one order, constants first.
  if (operation == Operation::add || operation == Operation::multiply)
    if (is_constant(a) == is_constant(b) ? b < a : is_constant(b)) std::swap(a, b);
  std::uint64_t const key = (static_cast<std::uint64_t>(operation) << 56) |
                            (static_cast<std::uint64_t>(a) << 28) | static_cast<std::uint64_t>(b);
  auto const known = found_.find(key);
  if (known != found_.end()) return known->second;
  bool const constant = is_constant(a) && is_constant(b);
  double const folded = constant ? value_of(operation, value(a), value(b)) : 0;
  return found_[key] = make({operation, constant, a, b, folded});
}

}  // namespace actio
