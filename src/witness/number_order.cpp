// The order of numbers, their sizes, and the bounds of balls, in the arithmetic in force.
#include <algorithm>
#include <cmath>

#include "witness/number_counts.hpp"
#include "witness/number_parts.hpp"

namespace actio {

using detail::arithmetic_in_force;
using detail::NumberParts;
using Kind = ArithmeticKind;

namespace {

float degree_seen = 0;

[[noreturn]] void no_order() {
  throw NoOrder(
      "numbers modulo a prime have no order: a claim that compares belongs to "
      "rational numbers, digits or balls");
}
bool compared(Number const& x, Number const& y, bool or_equal) {
  switch (arithmetic_in_force.kind()) {
    case Kind::hardware: {
      double const a = NumberParts::hardware(x), b = NumberParts::hardware(y);
      return or_equal ? a <= b : a < b;
    }
    case Kind::prime: {
      std::uint64_t const a = NumberParts::residue(x), b = NumberParts::residue(y);
      if (a > 1 || b > 1) no_order();
      return or_equal ? a <= b : a < b;
    }
    case Kind::rational: {
      int const sign = detail::rational_compare(x, y);
      return or_equal ? sign <= 0 : sign < 0;
    }
    case Kind::decimal:
      return detail::decimal_less(x, y, or_equal);
    default:
      return detail::ball_less(x, y, or_equal);
  }
}

}  // namespace

bool operator<(Number const& x, Number const& y) { return compared(x, y, false); }
bool operator<=(Number const& x, Number const& y) { return compared(x, y, true); }
bool operator==(Number const& x, Number const& y) {
  switch (arithmetic_in_force.kind()) {
    case Kind::hardware:
      return NumberParts::hardware(x) == NumberParts::hardware(y);
    case Kind::prime:
      return NumberParts::residue(x) == NumberParts::residue(y);
    case Kind::rational:
      return detail::rational_compare(x, y) == 0;
    case Kind::decimal:
      return detail::decimal_equal(x, y);
    default:
      return detail::ball_equal(x, y);
  }
}

Number magnitude(Number const& x) {
  switch (arithmetic_in_force.kind()) {
    case Kind::hardware:
      return Number(std::abs(NumberParts::hardware(x)));
    case Kind::prime:
      degree_seen = std::max(degree_seen, NumberParts::degree(x).numerator);
      return Number(NumberParts::word(x) != 0 ? 1 : 0);
    case Kind::ball:
      return detail::ball_magnitude(x);
    default:
      return x < Number() ? -x : x;
  }
}
Number abs(Number const& x) {
  if (arithmetic_in_force.kind() == Kind::prime && NumberParts::residue(x) > 1) no_order();
  return arithmetic_in_force.kind() == Kind::ball ? (x < Number() ? -x : x) : magnitude(x);
}
bool is_finite(Number const& x) {
  switch (arithmetic_in_force.kind()) {
    case Kind::hardware:
      return std::isfinite(NumberParts::hardware(x));
    case Kind::decimal:
      return detail::decimal_is_finite(x);
    case Kind::ball:
      return detail::ball_is_finite(x);
    default:
      return true;
  }
}

Number Number::lower() const {
  return arithmetic_in_force.kind() == Kind::ball ? detail::ball_bound(*this, false) : *this;
}
Number Number::upper() const {
  return arithmetic_in_force.kind() == Kind::ball ? detail::ball_bound(*this, true) : *this;
}
bool Number::holds_zero() const {
  return arithmetic_in_force.kind() == Kind::ball ? detail::ball_holds_zero(*this) : *this == Number();
}
Number Number::between(Number const& from, Number const& to) {
  if (arithmetic_in_force.kind() != Kind::ball)
    throw Error("only balls hold all numbers between two; the arithmetic in force is " +
                arithmetic_in_force.name());
  return detail::ball_between(from, to);
}

double largest_degree() { return degree_seen; }
void forget_degrees() { degree_seen = 0; }

}  // namespace actio
