#include "witness/number.hpp"

#include <algorithm>
#include <cmath>
#include <ostream>
#include <sstream>

#include "witness/field_number.hpp"
#include "witness/number_parts.hpp"

namespace actio {

using detail::arithmetic_in_force;
using detail::field_difference;
using detail::field_opposite;
using detail::field_product;
using detail::field_quotient;
using detail::field_sum;
using detail::NumberParts;
using detail::Operation;
using Kind = ArithmeticKind;

namespace {

std::uint64_t operations = 0;
float degree_seen = 0;

[[noreturn]] void no_order() {
  throw NoOrder(
      "numbers modulo a prime have no order: a claim that compares belongs to rational numbers, digits or "
      "balls");
}
/// z = x op y where numbers may stand in cells.
void operation(Operation op, Number& z, Number const& x, Number const& y) {
  switch (arithmetic_in_force.kind()) {
    case Kind::rational:
      return detail::rational_operation(op, z, x, y);
    case Kind::decimal:
      return detail::decimal_operation(op, z, x, y);
    default:
      return detail::ball_operation(op, z, x, y);
  }
}

}  // namespace

// ---- Making and copying

void Number::set_whole(std::int64_t n) {
  switch (arithmetic_in_force.kind()) {
    case Kind::hardware:
      word_ = std::bit_cast<std::int64_t>(static_cast<double>(n));
      return;
    case Kind::prime: {
      std::int64_t const p = static_cast<std::int64_t>(arithmetic_in_force.modulus()), r = n % p;
      word_ = r < 0 ? r + p : r;
      return;
    }
    case Kind::rational:
      if (n == INT64_MIN) return detail::rational_from_large(*this, n);
      word_ = n;
      return;
    default:
      constexpr std::int64_t limit = std::int64_t(1) << 53;
      if (n > -limit && n < limit)
        word_ = n;
      else if (arithmetic_in_force.kind() == Kind::decimal)
        detail::decimal_from_large(*this, n);
      else
        detail::ball_from_large(*this, n);
  }
}

void Number::set_double(double x) {
  if (arithmetic_in_force.exact() && !std::isfinite(x)) throw NotFinite("an exact number from a double");
  constexpr double limit = 9007199254740992.0;
  Kind const kind = arithmetic_in_force.kind();
  if (kind == Kind::hardware) {
    word_ = std::bit_cast<std::int64_t>(x);
  } else if (x > -limit && x < limit && x == std::trunc(x)) {
    set_whole(static_cast<std::int64_t>(x));
  } else if (kind == Kind::prime) {
    // m 2^e with whole m.
    int exponent = 0;
    double const mantissa = std::frexp(x, &exponent);
    Number const m(static_cast<std::int64_t>(std::ldexp(mantissa, 53)));
    Number const power = pow(Number(2), Number(std::abs(exponent - 53)));
    *this = exponent >= 53 ? m * power : m / power;
  } else if (kind == Kind::rational) {
    detail::rational_from_double(*this, x);
  } else if (kind == Kind::decimal) {
    detail::decimal_from_double(*this, x);
  } else {
    detail::ball_from_double(*this, x);
  }
}

Number Number::fraction(std::int64_t numerator, std::int64_t denominator) {
  return Number(numerator) / Number(denominator);
}

Number Number::field_draw(std::uint64_t residue) { return detail::field_number(residue, {1, 0}); }

Number Number::rounding() {
  switch (arithmetic_in_force.kind()) {
    case Kind::hardware:
      return Number(std::numeric_limits<double>::epsilon());
    case Kind::decimal:
    case Kind::ball:
      return pow(Number(2), Number(1 - arithmetic_in_force.bits()));
    default:
      return Number();
  }
}

void Number::copy_cell(Number const& x) {
  void const* const cell = NumberParts::cell(x);
  switch (x.mark_) {
    case detail::decimal_cell:
      word_ = reinterpret_cast<std::int64_t>(detail::copied_decimal(cell));
      return;
    case detail::rational_cell:
      word_ = reinterpret_cast<std::int64_t>(detail::copied_rational(cell));
      return;
    default:
      word_ = reinterpret_cast<std::int64_t>(detail::copied_ball(cell));
  }
}
void Number::assign_cell(Number const& x) {
  if (this == &x) return;
  release_cell();
  word_ = x.word_, mark_ = x.mark_;
  if (mark_ < 0) copy_cell(x);
}
void Number::release_cell() noexcept {
  void* const cell = reinterpret_cast<void*>(word_);
  switch (mark_) {
    case detail::decimal_cell:
      detail::release_decimal(cell);
      break;
    case detail::rational_cell:
      detail::release_rational(cell);
      break;
    case detail::ball_cell:
      detail::release_ball(cell);
      break;
    default:
      break;
  }
  word_ = 0, mark_ = 0;
}

void Number::bound(Number& x, double degree) {
  DegreeBound const known = NumberParts::degree(x);
  if (2 * degree >= static_cast<double>(known.numerator) + known.denominator) return;
  float const d = detail::rounded_up(static_cast<float>(degree));
  NumberParts::set(x, NumberParts::word(x), NumberParts::mark_of({d, d}));
}

// ---- The four operations

Number& Number::operator+=(Number const& y) {
  if (arithmetic_in_force.kind() == Kind::prime) return *this = field_sum(*this, y);
  if (arithmetic_in_force.kind() == Kind::hardware)
    NumberParts::set_double(*this, NumberParts::hardware(*this) + NumberParts::hardware(y));
  else
    operation(Operation::add, *this, *this, y);
  return *this;
}
Number& Number::operator-=(Number const& y) {
  if (arithmetic_in_force.kind() == Kind::prime) return *this = field_difference(*this, y);
  if (arithmetic_in_force.kind() == Kind::hardware)
    NumberParts::set_double(*this, NumberParts::hardware(*this) - NumberParts::hardware(y));
  else
    operation(Operation::subtract, *this, *this, y);
  return *this;
}
Number& Number::operator*=(Number const& y) {
  ++operations;
  if (arithmetic_in_force.kind() == Kind::prime) return *this = field_product(*this, y);
  if (arithmetic_in_force.kind() == Kind::hardware)
    NumberParts::set_double(*this, NumberParts::hardware(*this) * NumberParts::hardware(y));
  else
    operation(Operation::multiply, *this, *this, y);
  return *this;
}
Number& Number::operator/=(Number const& y) {
  ++operations;
  if (arithmetic_in_force.kind() == Kind::prime) return *this = field_quotient(*this, y);
  if (arithmetic_in_force.kind() == Kind::hardware)
    NumberParts::set_double(*this, NumberParts::hardware(*this) / NumberParts::hardware(y));
  else
    operation(Operation::divide, *this, *this, y);
  return *this;
}

Number operator+(Number const& x, Number const& y) {
  if (arithmetic_in_force.kind() == Kind::prime) return field_sum(x, y);
  Number z;
  if (arithmetic_in_force.kind() == Kind::hardware)
    NumberParts::set_double(z, NumberParts::hardware(x) + NumberParts::hardware(y));
  else
    operation(Operation::add, z, x, y);
  return z;
}
Number operator-(Number const& x, Number const& y) {
  if (arithmetic_in_force.kind() == Kind::prime) return field_difference(x, y);
  Number z;
  if (arithmetic_in_force.kind() == Kind::hardware)
    NumberParts::set_double(z, NumberParts::hardware(x) - NumberParts::hardware(y));
  else
    operation(Operation::subtract, z, x, y);
  return z;
}
Number operator*(Number const& x, Number const& y) {
  ++operations;
  if (arithmetic_in_force.kind() == Kind::prime) return field_product(x, y);
  Number z;
  if (arithmetic_in_force.kind() == Kind::hardware)
    NumberParts::set_double(z, NumberParts::hardware(x) * NumberParts::hardware(y));
  else
    operation(Operation::multiply, z, x, y);
  return z;
}
Number operator/(Number const& x, Number const& y) {
  ++operations;
  if (arithmetic_in_force.kind() == Kind::prime) return field_quotient(x, y);
  Number z;
  if (arithmetic_in_force.kind() == Kind::hardware)
    NumberParts::set_double(z, NumberParts::hardware(x) / NumberParts::hardware(y));
  else
    operation(Operation::divide, z, x, y);
  return z;
}
Number operator-(Number const& x) {
  if (arithmetic_in_force.kind() == Kind::prime) return field_opposite(x);
  if (arithmetic_in_force.kind() == Kind::hardware) return Number(-NumberParts::hardware(x));
  if (!NumberParts::in_cell(x)) return NumberParts::made(-NumberParts::word(x), NumberParts::mark(x));
  Number z;
  operation(Operation::subtract, z, z, x);
  return z;
}
void add_product(Number& z, Number const& x, Number const& y) {
  ++operations;
  if (arithmetic_in_force.kind() == Kind::prime) {
    if (!detail::literal_zero(x) && !detail::literal_zero(y)) z = field_sum(z, field_product(x, y));
  } else if (arithmetic_in_force.kind() == Kind::hardware) {
    double const term = NumberParts::hardware(x) * NumberParts::hardware(y);
    NumberParts::set_double(z, NumberParts::hardware(z) + term);
  } else {
    Number term;
    operation(Operation::multiply, term, x, y);
    operation(Operation::add, z, z, term);
  }
}

// ---- Order

namespace {
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

// ---- Saying what it is

double Number::as_double() const {
  switch (arithmetic_in_force.kind()) {
    case Kind::hardware:
      return NumberParts::hardware(*this);
    case Kind::prime:
      return word_ == 0 || word_ == 1 ? static_cast<double>(word_) : std::nan("");
    case Kind::rational:
      return detail::rational_to_double(*this);
    case Kind::decimal:
      return detail::decimal_to_double(*this);
    default:
      return detail::ball_to_double(*this);
  }
}
std::string Number::text() const {
  return arithmetic_in_force.kind() == Kind::prime ? std::to_string(residue()) : show(as_double());
}
DegreeBound Number::degree() const {
  return arithmetic_in_force.kind() == Kind::prime ? NumberParts::degree(*this) : DegreeBound{};
}
std::uint64_t Number::residue() const {
  if (arithmetic_in_force.kind() != Kind::prime) throw NoOrder("a residue: a prime field is needed");
  return static_cast<std::uint64_t>(word_);
}
std::ostream& operator<<(std::ostream& out, Number const& x) { return out << x.text(); }

double largest_degree() { return degree_seen; }
void forget_degrees() { degree_seen = 0; }
std::uint64_t operations_done() { return operations; }
std::uint64_t cells_allocated() { return detail::cells_made; }

}  // namespace actio
