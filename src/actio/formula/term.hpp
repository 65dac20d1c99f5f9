// Entries of a tape that add, multiply and go into functions like numbers.
//
// A callable over any scalar, called with terms, records itself:
//
//     TapeBuilder b(2);
//     Term const x(b, b.input(0)), y(b, b.input(1));
//     Term const f = x * x / 2 + sin(y);
//     Tape const tape = b.tape(std::vector{f.entry()});
#pragma once

#include <concepts>
#include <type_traits>

#include "actio/formula/decimal_constant.hpp"
#include "actio/formula/tape_builder.hpp"

namespace actio {

/// A number of the language: a constant beside terms.
template <class T>
concept BuiltInNumber = std::is_arithmetic_v<T>;

/// An entry of a tape that is being recorded.
class Term {
 public:
  /// @param b  outlives the term
  Term(TapeBuilder& b, TapeBuilder::Entry e) : builder_(&b), entry_(e) {}

  TapeBuilder& builder() const { return *builder_; }   ///< who records it
  TapeBuilder::Entry entry() const { return entry_; }  ///< which entry it is

  friend Term operator+(Term const& x, Term const& y) { return x.with(&TapeBuilder::add, y); }
  friend Term operator-(Term const& x, Term const& y) { return x.with(&TapeBuilder::subtract, y); }
  friend Term operator*(Term const& x, Term const& y) { return x.with(&TapeBuilder::multiply, y); }
  friend Term operator/(Term const& x, Term const& y) { return x.with(&TapeBuilder::divide, y); }
  friend Term operator-(Term const& x) { return {x.builder(), x.builder().negate(x.entry())}; }

  template <BuiltInNumber T>
  friend Term operator+(Term const& x, T c) {
    return x + x.constant(c);
  }
  template <BuiltInNumber T>
  friend Term operator-(Term const& x, T c) {
    return x - x.constant(c);
  }
  template <BuiltInNumber T>
  friend Term operator*(Term const& x, T c) {
    return x * x.constant(c);
  }
  template <BuiltInNumber T>
  friend Term operator/(Term const& x, T c) {
    return x / x.constant(c);
  }
  template <BuiltInNumber T>
  friend Term operator+(T c, Term const& x) {
    return x.constant(c) + x;
  }
  template <BuiltInNumber T>
  friend Term operator-(T c, Term const& x) {
    return x.constant(c) - x;
  }
  template <BuiltInNumber T>
  friend Term operator*(T c, Term const& x) {
    return x.constant(c) * x;
  }
  template <BuiltInNumber T>
  friend Term operator/(T c, Term const& x) {
    return x.constant(c) / x;
  }

  /// A constant of the same tape: a whole number, or the shortest decimal number that reads as a double.
  /// @throws NotFinite
  template <BuiltInNumber T>
  Term constant(T c) const {
    if constexpr (std::integral<T>)
      return {builder(), builder().number(ExactRatio{static_cast<std::int64_t>(c), 1})};
    else
      return {builder(), decimal_constant(builder(), c)};
  }

 private:
  Term with(TapeBuilder::Entry (TapeBuilder::*join)(TapeBuilder::Entry, TapeBuilder::Entry),
            Term const& y) const {
    return {builder(), (builder().*join)(entry(), y.entry())};
  }
  TapeBuilder* builder_;
  TapeBuilder::Entry entry_;
};

/// A whole number beside a term.
inline Term whole_beside(Term const& x, int n) { return x.constant(n); }

/// A function of one number, recorded.
inline Term elementary(Operation function, Term const& x) {
  return {x.builder(), x.builder().apply(function, x.entry())};
}
/// A power, recorded.
inline Term power(Term const& x, Term const& exponent) {
  return {x.builder(), x.builder().power(x.entry(), exponent.entry())};
}

inline Term sqrt(Term const& x) { return elementary(Operation::sqrt, x); }
inline Term exp(Term const& x) { return elementary(Operation::exp, x); }
inline Term log(Term const& x) { return elementary(Operation::log, x); }
inline Term sin(Term const& x) { return elementary(Operation::sin, x); }
inline Term cos(Term const& x) { return elementary(Operation::cos, x); }
inline Term atan2(Term const& y, Term const& x) {
  return {x.builder(), x.builder().apply(Operation::atan2, y.entry(), x.entry())};
}

}  // namespace actio
