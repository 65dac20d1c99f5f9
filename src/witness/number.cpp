// Numbers: how they are made and copied, and what they say of themselves.
#include "witness/number.hpp"

#include <cmath>
#include <limits>
#include <ostream>
#include <string>

#include "witness/field_number.hpp"
#include "witness/number_parts.hpp"

namespace actio {

using detail::arithmetic_in_force;
using detail::NumberParts;
using Kind = ArithmeticKind;

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

}  // namespace actio
