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
};

/// How many operations there are.
inline constexpr int operations = static_cast<int>(Operation::atanh) + 1;

/// How they are called, where a formula can call them.
inline constexpr std::array<std::string_view, operations> operation_names{
    "input", "number", "pi",   "+",    "-",    "*",    "/",     "-",     "^",    "atan2",
    "hypot", "sqrt",   "cbrt", "exp",  "log",  "log2", "log10", "sin",   "cos",  "tan",
    "asin",  "acos",   "atan", "sinh", "cosh", "tanh", "asinh", "acosh", "atanh"};

/// Its name.
constexpr std::string_view name_of(Operation operation) {
  return operation_names[static_cast<std::size_t>(operation)];
}

/// Whether it is a function that is called with an argument in brackets.
constexpr bool of_one_argument(Operation operation) { return operation >= Operation::sqrt; }
/// Whether it is a function that is called with two arguments in brackets.
constexpr bool of_two_arguments(Operation operation) {
  return operation == Operation::atan2 || operation == Operation::hypot;
}
/// Whether a formula calls it by its name.
constexpr bool is_function(Operation operation) {
  return of_one_argument(operation) || of_two_arguments(operation);
}
/// Whether it has two operands.
constexpr bool joins_two(Operation operation) {
  return operation >= Operation::add && operation <= Operation::hypot && operation != Operation::negate;
}

}  // namespace actio
