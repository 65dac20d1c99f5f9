// Numbers of a prime field: representatives, and bounds of their degrees as functions of the random draws.
#pragma once

#include "witness/number_parts.hpp"
#include "witness/prime_field.hpp"

namespace actio::detail {

/// A sum of degrees, rounded up where a float cannot hold it.
inline float rounded_up(float degree) { return degree < 16777216.0f ? degree : degree * 1.0000002f; }

/// Whether a number is the word zero, of degree zero.
inline bool literal_zero(Number const& x) { return NumberParts::word(x) == 0 && NumberParts::mark(x) == 0; }

inline DegreeBound degree_of_sum(DegreeBound const& x, DegreeBound const& y) {
  if (x.denominator == 0 && y.denominator == 0)
    return {x.numerator < y.numerator ? y.numerator : x.numerator, 0};
  float const a = x.numerator + y.denominator, b = y.numerator + x.denominator;
  return {rounded_up(a < b ? b : a), rounded_up(x.denominator + y.denominator)};
}
inline DegreeBound degree_of_product(DegreeBound const& x, DegreeBound const& y) {
  return {rounded_up(x.numerator + y.numerator), rounded_up(x.denominator + y.denominator)};
}

/// The number with this representative.
inline Number field_number(std::uint64_t residue, DegreeBound const& degree) {
  return NumberParts::made(static_cast<std::int64_t>(residue), NumberParts::mark_of(degree));
}

inline Number field_sum(Number const& x, Number const& y) {
  if (literal_zero(x)) return y;
  if (literal_zero(y)) return x;
  return field_number(
      prime_field::sum(NumberParts::residue(x), NumberParts::residue(y), arithmetic_in_force.modulus()),
      degree_of_sum(NumberParts::degree(x), NumberParts::degree(y)));
}
inline Number field_opposite(Number const& x) {
  if (NumberParts::word(x) == 0) return x;
  return field_number(arithmetic_in_force.modulus() - NumberParts::residue(x), NumberParts::degree(x));
}
inline Number field_difference(Number const& x, Number const& y) {
  if (literal_zero(x)) return field_opposite(y);
  if (literal_zero(y)) return x;
  return field_number(prime_field::difference(NumberParts::residue(x), NumberParts::residue(y),
                                              arithmetic_in_force.modulus()),
                      degree_of_sum(NumberParts::degree(x), NumberParts::degree(y)));
}
inline Number field_product(Number const& x, Number const& y) {
  if (literal_zero(x) || literal_zero(y)) return Number();
  return field_number(
      prime_field::product(NumberParts::residue(x), NumberParts::residue(y), arithmetic_in_force.modulus()),
      degree_of_product(NumberParts::degree(x), NumberParts::degree(y)));
}
/// @throws DivisionByZero
inline Number field_quotient(Number const& x, Number const& y) {
  if (NumberParts::word(y) == 0) throw DivisionByZero();
  if (literal_zero(x)) return x;
  std::uint64_t const p = arithmetic_in_force.modulus();
  DegreeBound const below = NumberParts::degree(y);
  return field_number(
      prime_field::product(NumberParts::residue(x), prime_field::inverse(NumberParts::residue(y), p), p),
      degree_of_product(NumberParts::degree(x), {below.denominator, below.numerator}));
}

}  // namespace actio::detail
