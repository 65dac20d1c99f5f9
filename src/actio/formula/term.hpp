// Entries of a tape that add, multiply and go into functions like numbers.
//
// A callable over any scalar, called with terms, records itself:
//
//     TapeBuilder b(2);
//     Term const x(b, b.input(0)), y(b, b.input(1));
//     Term const f = x * x / 2 + sin(y);
//     Tape const tape = b.tape(std::vector{f.entry()});
#pragma once

#include "actio/formula/tape_builder.hpp"

namespace actio {

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

  friend Term operator+(Term const& x, int n) { return x + x.whole(n); }
  friend Term operator-(Term const& x, int n) { return x - x.whole(n); }
  friend Term operator*(Term const& x, int n) { return x * x.whole(n); }
  friend Term operator/(Term const& x, int n) { return x / x.whole(n); }
  friend Term operator+(int n, Term const& x) { return x.whole(n) + x; }
  friend Term operator-(int n, Term const& x) { return x.whole(n) - x; }
  friend Term operator*(int n, Term const& x) { return x.whole(n) * x; }
  friend Term operator/(int n, Term const& x) { return x.whole(n) / x; }

  /// A whole number that the same tape records.
  Term whole(int n) const { return {builder(), builder().number(n)}; }

 private:
  Term with(TapeBuilder::Entry (TapeBuilder::*join)(TapeBuilder::Entry, TapeBuilder::Entry),
            Term const& y) const {
    return {builder(), (builder().*join)(entry(), y.entry())};
  }
  TapeBuilder* builder_;
  TapeBuilder::Entry entry_;
};

/// A whole number beside a term.
inline Term whole_beside(Term const& x, int n) { return x.whole(n); }

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
