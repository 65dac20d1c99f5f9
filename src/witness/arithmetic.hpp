// The arithmetic of the run: what the four operations on a Number (number.hpp) mean while it is in force.
//
// One arithmetic is in force at a time, for the whole program: this serves programs of a single thread. What
// was made under one arithmetic is not to be used under another.
#pragma once

#include <cstdint>
#include <string>

#include "actio/numbers/errors.hpp"

namespace actio {

/// Two numbers were compared, or the size of one was asked for, in a field without order.
struct NoOrder : Error {
  using Error::Error;
};
/// A question that the precision of balls does not decide: more digits may.
struct Undecided : Error {
  using Error::Error;
};

/// The kinds of arithmetic there are.
enum class ArithmeticKind : unsigned char {
  hardware,  ///< the machine's double
  prime,     ///< the integers modulo a prime
  rational,  ///< fractions of whole numbers of any size
  decimal,   ///< floating point with as many decimal digits as wanted
  ball       ///< floating point with as many digits as wanted and a bound of its error
};

/// An arithmetic: a kind, with its digits or its modulus.
class Arithmetic {
 public:
  static constexpr std::uint64_t mersenne = (std::uint64_t(1) << 61) - 1;  ///< \f$2^{61}-1\f$, a prime
  static constexpr int fewest_digits = 16;                                 ///< of decimal numbers and balls
  static constexpr int most_digits = 100'000;                              ///< more would not fit into memory

  /// That of the machine's double, bit for bit.
  static Arithmetic hardware() { return Arithmetic(ArithmeticKind::hardware, 53, 0); }
  /// That of the rational numbers.
  static Arithmetic rationals() { return Arithmetic(ArithmeticKind::rational, 0, 0); }
  /// That of the integers modulo a prime.
  /// @param p  between \f$2^{40}\f$ and \f$2^{62}\f$; square roots need p = 3 mod 4
  /// @throws OutsideDomain  where p is no prime or not between these bounds
  static Arithmetic prime_field(std::uint64_t p = mersenne);
  /// Floating point of that many decimal digits, rounded to the nearest number.
  /// @throws OutsideDomain  below 16 digits and above 100000
  static Arithmetic decimal(int digits);
  /// Balls whose centres have that many decimal digits.
  /// @throws OutsideDomain  below 16 digits and above 100000
  static Arithmetic balls(int digits);

  ArithmeticKind kind() const { return kind_; }
  /// Whether nothing is ever rounded: the rationals and the prime fields.
  bool exact() const { return kind_ == ArithmeticKind::rational || kind_ == ArithmeticKind::prime; }
  /// Whether numbers are larger and smaller than others: all but the prime fields.
  bool ordered() const { return kind_ != ArithmeticKind::prime; }
  /// Digits of the significand in base 2; 0 where nothing is rounded.
  int bits() const { return bits_; }
  /// Decimal digits that a number carries; 0 where nothing is rounded.
  int digits() const;
  /// The prime; 0 in other arithmetics.
  std::uint64_t modulus() const { return kind_ == ArithmeticKind::prime ? parameter_ : 0; }
  /// `double`, `prime`, `rational`, `dec50`, `ball`, ...
  std::string name() const;

 private:
  Arithmetic(ArithmeticKind kind, int bits, std::uint64_t parameter)
      : kind_(kind), bits_(bits), parameter_(parameter) {}
  ArithmeticKind kind_;
  int bits_;
  std::uint64_t parameter_;  // the modulus, or the decimal digits
};

/// Whether p is a prime: Miller's test with the twelve bases that decide it for all 64-bit numbers.
bool is_prime(std::uint64_t p);

namespace detail {
inline Arithmetic arithmetic_in_force = Arithmetic::hardware();
inline std::uint64_t spell = 1;
}  // namespace detail

/// The arithmetic in force; at the start of a program that of the machine's double.
inline Arithmetic const& current_arithmetic() { return detail::arithmetic_in_force; }
/// A number that no other spell of an arithmetic has: tables of numbers are valid as long as it stays the
/// same.
inline std::uint64_t current_spell() { return detail::spell; }

/// Puts an arithmetic in force for as long as this object lives; the former one returns after it.
class WithArithmetic {
 public:
  /// @param arithmetic  in force from here on
  explicit WithArithmetic(Arithmetic const& arithmetic);
  ~WithArithmetic();
  WithArithmetic(WithArithmetic const&) = delete;
  WithArithmetic& operator=(WithArithmetic const&) = delete;

 private:
  Arithmetic former_;
};

}  // namespace actio
