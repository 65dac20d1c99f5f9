// The four operations on numbers, in the arithmetic in force.
#include <cstdint>

#include "witness/field_number.hpp"
#include "witness/number_counts.hpp"
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

std::uint64_t operations_done() { return operations; }
std::uint64_t cells_allocated() { return detail::cells_made; }

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

}  // namespace actio
