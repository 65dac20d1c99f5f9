// Functions of numbers: roots, exponentials and the like in each arithmetic, or a refusal where its field
// does not hold them.
#include <cmath>
#include <unordered_set>

#include "actio/numbers/square_root.hpp"
#include "witness/number.hpp"
#include "witness/number_counts.hpp"
#include "witness/number_parts.hpp"
#include "witness/prime_field.hpp"

namespace actio {

using detail::arithmetic_in_force;
using detail::Function;
using detail::NumberParts;
using Kind = ArithmeticKind;

namespace {

std::unordered_set<std::uint64_t> roots;

Number field_root(Number const& x) {
  std::uint64_t const p = arithmetic_in_force.modulus(), square = NumberParts::residue(x);
  if (p % 4 != 3)
    throw NotInThisField("sqrt", "a modulus that is 3 mod 4 is needed for roots, such as 2^61 - 1; remainder",
                         static_cast<double>(p % 4), 3);
  std::uint64_t const root = prime_field::root(square, p);
  if (prime_field::product(root, root, p) != square)
    throw NotASquare(
        "sqrt", "a number modulo p has a root where it is a square, half of all are; squares at hand", 0, 1);
  if (NumberParts::degree(x).numerator != 0 || NumberParts::degree(x).denominator != 0) roots.insert(square);
  return NumberParts::made(static_cast<std::int64_t>(root), NumberParts::mark_of(NumberParts::degree(x)));
}

[[noreturn]] void not_here(char const* function, Number const& x) {
  throw NotInThisField(
      function,
      "double, decimal digits and balls have this function, " +
          std::string(arithmetic_in_force.kind() == Kind::prime ? "a prime field has not"
                                                                : "the rational numbers have not"),
      x.convert_to<double>(), 0);
}

/// In the order of `Function`.
constexpr struct {
  char const* name;
  double (*of_double)(double);
} functions[] = {{"sqrt", std::sqrt}, {"exp", std::exp},   {"log", std::log},   {"sin", std::sin},
                 {"cos", std::cos},   {"tan", std::tan},   {"asin", std::asin}, {"acos", std::acos},
                 {"atan", std::atan}, {"sinh", std::sinh}, {"cosh", std::cosh}, {"tanh", std::tanh}};

Number function(Function f, Number const& x) {
  switch (arithmetic_in_force.kind()) {
    case Kind::hardware:
      return Number(functions[static_cast<int>(f)].of_double(NumberParts::hardware(x)));
    case Kind::decimal:
      return detail::decimal_function(f, x);
    case Kind::ball:
      return detail::ball_function(f, x);
    default:
      break;
  }
  if (f == Function::sqrt)
    return arithmetic_in_force.kind() == Kind::prime ? field_root(x) : detail::rational_root(x);
  // What they are at zero, or at one, needs no field of its own.
  bool const at_zero = x == Number(0);
  switch (f) {
    case Function::exp:
    case Function::cos:
    case Function::cosh:
      if (at_zero) return Number(1);
      break;
    case Function::log:
      if (x == Number(1)) return Number(0);
      break;
    case Function::acos:
      break;
    default:
      if (at_zero) return Number(0);
  }
  not_here(functions[static_cast<int>(f)].name, x);
}

}  // namespace

Number sqrt(Number const& x) { return function(Function::sqrt, x); }
Number exp(Number const& x) { return function(Function::exp, x); }
Number log(Number const& x) { return function(Function::log, x); }
Number sin(Number const& x) { return function(Function::sin, x); }
Number cos(Number const& x) { return function(Function::cos, x); }
Number tan(Number const& x) { return function(Function::tan, x); }
Number asin(Number const& x) { return function(Function::asin, x); }
Number acos(Number const& x) { return function(Function::acos, x); }
Number atan(Number const& x) { return function(Function::atan, x); }
Number sinh(Number const& x) { return function(Function::sinh, x); }
Number cosh(Number const& x) { return function(Function::cosh, x); }
Number tanh(Number const& x) { return function(Function::tanh, x); }

Number atan2(Number const& y, Number const& x) {
  switch (arithmetic_in_force.kind()) {
    case Kind::hardware:
      return Number(std::atan2(NumberParts::hardware(y), NumberParts::hardware(x)));
    case Kind::decimal:
      return detail::decimal_atan2(y, x);
    case Kind::ball:
      return detail::ball_atan2(y, x);
    default:
      not_here("atan2", y);
  }
}
Number pow(Number const& x, Number const& exponent) {
  switch (arithmetic_in_force.kind()) {
    case Kind::hardware:
      return Number(std::pow(NumberParts::hardware(x), NumberParts::hardware(exponent)));
    case Kind::decimal:
      return detail::decimal_pow(x, exponent);
    case Kind::ball:
      return detail::ball_pow(x, exponent);
    default:
      break;
  }
  // By repeated squaring. Modulo p an exponent is a small whole number, or the opposite of one.
  std::int64_t e = NumberParts::word(exponent);
  bool whole = !NumberParts::in_cell(exponent);
  constexpr std::int64_t limit = 1'000'000;
  if (arithmetic_in_force.kind() == Kind::rational)
    whole = whole && NumberParts::mark(exponent) == 0;
  else if (e > limit)
    e -= static_cast<std::int64_t>(arithmetic_in_force.modulus());
  if (!whole || e > limit || e < -limit) not_here("pow", x);
  Number result(1), square = x;
  for (std::int64_t k = std::abs(e); k != 0; k >>= 1) {
    if (k & 1) result *= square;
    if (k > 1) square *= square;
  }
  return e < 0 ? Number(1) / result : result;
}

Number frexp(Number const& x, int* exponent) {
  std::frexp(x.convert_to<double>(), exponent);
  return ldexp(x, -*exponent);
}
Number ldexp(Number const& x, int n) {
  if (arithmetic_in_force.kind() == Kind::hardware) return Number(std::ldexp(NumberParts::hardware(x), n));
  Number const power = pow(Number(2), Number(std::abs(n)));
  return n < 0 ? x / power : x * power;
}

int roots_taken() { return static_cast<int>(roots.size()); }
void forget_roots() { roots.clear(); }

}  // namespace actio
