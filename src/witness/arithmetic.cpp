#include "witness/arithmetic.hpp"

namespace actio {

namespace {

/// Binary digits that carry so many decimal ones: as many as Boost's cpp_bin_float takes.
int bits_for(int digits) { return static_cast<int>(static_cast<long>(digits) * 1000 / 301 + 2); }

void require_digits(int digits) {
  if (digits < Arithmetic::fewest_digits || digits > Arithmetic::most_digits)
    throw OutsideDomain(
        "arithmetic", "16 to 100000 decimal digits are offered; digits asked for", digits,
        digits < Arithmetic::fewest_digits ? Arithmetic::fewest_digits : Arithmetic::most_digits);
}

}  // namespace

Arithmetic Arithmetic::prime_field(std::uint64_t p) {
  constexpr std::uint64_t low = std::uint64_t(1) << 40, high = std::uint64_t(1) << 62;
  if (p <= low || p >= high)
    throw OutsideDomain("arithmetic",
                        "a modulus between 2^40 and 2^62 is needed, such as 2^61 - 1 = 2305843009213693951",
                        static_cast<double>(p), static_cast<double>(p <= low ? low : high));
  if (!is_prime(p))
    throw OutsideDomain(
        "arithmetic",
        "the modulus " + std::to_string(p) + " is no prime; 2305843009213693951 is one; primes wanted", 0, 1);
  return Arithmetic(ArithmeticKind::prime, 0, p);
}
Arithmetic Arithmetic::decimal(int digits) {
  require_digits(digits);
  return Arithmetic(ArithmeticKind::decimal, bits_for(digits), static_cast<std::uint64_t>(digits));
}
Arithmetic Arithmetic::balls(int digits) {
  require_digits(digits);
  return Arithmetic(ArithmeticKind::ball, bits_for(digits), static_cast<std::uint64_t>(digits));
}

int Arithmetic::digits() const {
  switch (kind_) {
    case ArithmeticKind::hardware:
      return 15;
    case ArithmeticKind::decimal:
    case ArithmeticKind::ball:
      return static_cast<int>(parameter_);
    default:
      return 0;
  }
}

std::string Arithmetic::name() const {
  switch (kind_) {
    case ArithmeticKind::hardware:
      return "double";
    case ArithmeticKind::prime:
      return "prime";
    case ArithmeticKind::rational:
      return "rational";
    case ArithmeticKind::decimal:
      return "dec" + std::to_string(parameter_);
    default:
      return "ball";
  }
}

WithArithmetic::WithArithmetic(Arithmetic const& arithmetic) : former_(detail::arithmetic_in_force) {
  detail::arithmetic_in_force = arithmetic;
  ++detail::spell;
}
WithArithmetic::~WithArithmetic() {
  detail::arithmetic_in_force = former_;
  ++detail::spell;
}

}  // namespace actio
