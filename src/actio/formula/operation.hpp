// The operations of a formula, and the names under which it calls its functions.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

namespace actio {

/// What an entry of a tape is, or does.
enum class Operation : std::uint8_t {
  // Leaves.
  input,   ///< a number that the formula is given
  number,  ///< a constant
  pi,      ///< half a turn
  // Arithmetic.
  add,       ///< a sum
  subtract,  ///< a difference
  multiply,  ///< a product
  divide,    ///< a quotient
  negate,    ///< minus a number
  // Functions of two numbers.
  power,  ///< with a constant exponent
  atan2,  ///< the angle of a point (x, y), given y first
  hypot,  ///< the length of (x, y)
  // Functions of two numbers with kinks or jumps. What is true is 1, what is false 0; any number but 0 holds.
  less,     ///< whether the first is less
  at_most,  ///< whether the first is no larger
  equal,    ///< whether both are equal
  unequal,  ///< whether they are not
  both,     ///< whether both hold
  either,   ///< whether one holds
  where,    ///< the second where the first holds, else nothing: -0, which changes no sum
  unless,   ///< the second where the first does not hold, else nothing
  min,      ///< the smaller one
  max,      ///< the larger one
  // Functions of one number.
  sqrt,   ///< square root
  cbrt,   ///< cube root
  exp,    ///< exponential
  log,    ///< natural logarithm
  log2,   ///< logarithm to base 2
  log10,  ///< logarithm to base 10
  sin,    ///< sine
  cos,    ///< cosine
  tan,    ///< tangent
  asin,   ///< arc sine
  acos,   ///< arc cosine
  atan,   ///< arc tangent
  sinh,   ///< hyperbolic sine
  cosh,   ///< hyperbolic cosine
  tanh,   ///< hyperbolic tangent
  asinh,  ///< inverse of the hyperbolic sine
  acosh,  ///< inverse of the hyperbolic cosine
  atanh,  ///< inverse of the hyperbolic tangent
  // Functions of one number with kinks or jumps.
  abs,    ///< modulus
  sign,   ///< -1, 0 or 1
  floor,  ///< the next whole number below
  ceil,   ///< the next whole number above
  round,  ///< the nearest whole number, away from zero where two are as near
};

/// How many operations there are.
inline constexpr int operations = static_cast<int>(Operation::round) + 1;

/// How they are called, where a formula can call them.
inline constexpr std::array<std::string_view, operations> operation_names{
    "input", "number", "pi",   "+",     "-",     "*",     "/",   "-",    "^",     "atan2", "hypot",
    "<",     "<=",     "==",   "!=",    "&&",    "||",    "? :", "? :",  "min",   "max",   "sqrt",
    "cbrt",  "exp",    "log",  "log2",  "log10", "sin",   "cos", "tan",  "asin",  "acos",  "atan",
    "sinh",  "cosh",   "tanh", "asinh", "acosh", "atanh", "abs", "sign", "floor", "ceil",  "round"};

/// Its name.
constexpr std::string_view name_of(Operation operation) {
  return operation_names[static_cast<std::size_t>(operation)];
}

/// Whether it is a function that is called with an argument in brackets.
constexpr bool of_one_argument(Operation operation) { return operation >= Operation::sqrt; }
/// Whether it is a function that is called with two arguments in brackets, or more of them.
constexpr bool of_two_arguments(Operation operation) {
  return operation == Operation::atan2 || operation == Operation::hypot || operation == Operation::min ||
         operation == Operation::max;
}
/// Whether it is smooth where it is defined, as all are but comparisons, cases and functions with kinks.
constexpr bool is_smooth(Operation operation) {
  return operation < Operation::less || (Operation::max < operation && operation < Operation::abs);
}
/// Whether a formula calls it by its name.
constexpr bool is_function(Operation operation) {
  return of_one_argument(operation) || of_two_arguments(operation);
}
/// Whether it has two operands.
constexpr bool joins_two(Operation operation) {
  return operation >= Operation::add && operation <= Operation::max && operation != Operation::negate;
}

}  // namespace actio
