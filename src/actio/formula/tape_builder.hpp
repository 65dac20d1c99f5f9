// Records a formula operation by operation, and simplifies it on the way.
//
// Constants are folded exactly, as ratios of 64-bit integers; what does not fit, and what is irrational,
// stays an operation on constants, which over double is carried out once for all. Constant factors move to
// the front, so that x*0, x*1, x + 0, 2*(3*x), x + x and the second derivatives of a quadratic form become
// what they should be.
#pragma once

#include <cmath>
#include <optional>
#include <span>

#include "actio/formula/tape.hpp"
#include "actio/formula/tape_entries.hpp"
#include "actio/formula/tape_schedule.hpp"

namespace actio {

/// Records operations on entries: `b.add(b.input(0), b.number(1))`.
class TapeBuilder : public TapeEntries {
 public:
  using TapeEntries::TapeEntries;

  Entry add(Entry a, Entry b);       ///< \f$a + b\f$
  Entry subtract(Entry a, Entry b);  ///< \f$a - b\f$
  Entry multiply(Entry a, Entry b);  ///< \f$ab\f$
  Entry divide(Entry a, Entry b);    ///< \f$a/b\f$
  Entry negate(Entry a);             ///< \f$-a\f$
  /// \f$a^n\f$ by products.
  Entry whole_power(Entry a, int n);
  /// \f$a^b\f$: products where b is a whole number up to 64 in size, roots where it is 1/2 or -1/2, a power
  /// where it is another constant, else \f$\exp(b\log a)\f$.
  Entry power(Entry a, Entry b);
  /// A function of one number.
  Entry apply(Operation function, Entry a);
  /// A function of two numbers, as `atan2(a, b)`.
  Entry apply(Operation function, Entry a, Entry b) { return entry(function, a, b); }
  /// Any operation; where it has one operand, b is not looked at.
  Entry record(Operation operation, Entry a, Entry b);
  /// The same as it stands, so that over double it is rounded as in C++; powers with the exponents 2, 3 and
  /// 4 are products from the left.
  Entry as_written(Operation operation, Entry a, Entry b);

  /// These entries and what they need, as a tape.
  Tape tape(std::span<Entry const> outputs) const { return schedule(*this, outputs); }

 private:
  /// An entry as a constant times another entry.
  struct Multiple {
    std::optional<Entry> factor;  // nothing where it is 1
    Entry rest;
  };
  Multiple multiple(Entry e);
  bool is_reciprocal(Entry e) const { return operation(e) == Operation::divide && is(first(e), 1); }
  Entry factor_of(Multiple const& m) { return m.factor ? *m.factor : number(1); }
  /// A constant that is an ordinary double: neither infinite nor so small that it lost digits.
  std::optional<Entry> in_range(Entry constant) const {
    return std::isnormal(value(constant)) ? std::optional(constant) : std::nullopt;
  }
  Entry folded(Operation operation, Entry a, Entry b);
  std::optional<Entry> collected(Operation sign, Entry a, Entry b);
  std::optional<ExactRatio> folded(Operation function, ExactRatio const& x) const;
};

inline TapeBuilder::Entry TapeBuilder::apply(Operation function, Entry a) {
  if (auto const* x = ratio_of(a))
    if (auto const y = folded(function, *x)) return number(*y);
  return entry(function, a);
}

}  // namespace actio
