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
  explicit TapeEntries(int inputs, std::size_t most = most_instructions);

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

}  // namespace actio
