// Number: a scalar whose arithmetic is chosen when the program runs.
//
// A formula is compiled once and evaluated in hardware double, in decimal digits of any number, over the
// rationals, over a prime field or in balls, whichever is in force (arithmetic.hpp). A number has 16 bytes.
// Doubles, elements of the field, fractions of two 64-bit integers and small whole numbers of any arithmetic
// stand in them; what does not fit stands in a cell, taken from a list of free ones.
//
// A field element carries an upper bound of its degree as a rational function of the random draws
// (DegreeBound), found by running the formula: a draw has degree one, constants have degree zero, sums and
// products have what their terms allow.
#pragma once

#include <bit>
#include <concepts>
#include <cstdint>
#include <iosfwd>
#include <limits>
#include <string>
#include <type_traits>

#include "actio/numbers/dual.hpp"
#include "witness/arithmetic.hpp"

namespace actio {

class Number;

/// Degrees of numerator and denominator of a rational function of the draws: upper bounds, rounded up.
struct DegreeBound {
  float numerator = 0;
  float denominator = 0;
};

namespace detail {
struct NumberParts;
}

/// A number of the arithmetic in force. See arithmetic.hpp for who may use it: one thread, and only under the
/// arithmetic it was made in.
class Number {
 public:
  /// Zero.
  [[gnu::always_inline]] Number() noexcept : word_(0), mark_(0) {}
  /// A whole number.
  template <std::integral T>
  Number(T n) : Number() {
    if (n != 0) set_whole(static_cast<std::int64_t>(n));
  }
  /// The number that a double is, exactly; modulo p and over the rationals it must be finite.
  /// @throws NotFinite  over an exact arithmetic
  Number(double x) : Number() { set_double(x); }
  [[gnu::always_inline]] Number(Number const& x) : word_(x.word_), mark_(x.mark_) {
    if (mark_ < 0) [[unlikely]]
      copy_cell(x);
  }
  [[gnu::always_inline]] Number(Number&& x) noexcept : word_(x.word_), mark_(x.mark_) {
    x.word_ = 0, x.mark_ = 0;
  }
  [[gnu::always_inline]] Number& operator=(Number const& x) {
    if (mark_ >= 0 && x.mark_ >= 0) [[likely]]
      word_ = x.word_, mark_ = x.mark_;
    else
      assign_cell(x);
    return *this;
  }
  [[gnu::always_inline]] Number& operator=(Number&& x) noexcept {
    std::int64_t const word = word_, mark = mark_;
    word_ = x.word_, mark_ = x.mark_;
    x.word_ = word, x.mark_ = mark;
    return *this;
  }
  [[gnu::always_inline]] ~Number() {
    if (mark_ < 0) [[unlikely]]
      release_cell();
  }

  /// The next number of a sequence of random draws: uniform over the prime field, a fraction k/64 with |k| at
  /// most 64 over the rationals, elsewhere the fraction k/65537 that double has.
  /// @param draw  a source with `below(count)`, draw.hpp
  template <class Draw>
  static Number drawn(Draw& draw) {
    switch (current_arithmetic().kind()) {
      case ArithmeticKind::prime:
        return field_draw(draw.below(current_arithmetic().modulus()));
      case ArithmeticKind::rational:
        return fraction(static_cast<std::int64_t>(draw.below(129)) - 64, 64);
      default:
        return fraction(static_cast<std::int64_t>(draw.below(Draw::numerators)) - (Draw::denominator - 1),
                        Draw::denominator);
    }
  }
  /// The quotient of two whole numbers, the second positive.
  static Number fraction(std::int64_t numerator, std::int64_t denominator);
  /// Spacing of the numbers next to 1; 0 where nothing is rounded.
  static Number rounding();
  /// The arithmetic in force: what makes this type a scalar of the run (scalar.hpp).
  static Arithmetic const& arithmetic() { return current_arithmetic(); }
  /// \ref current_spell
  static std::uint64_t spell() { return current_spell(); }

  Number& operator+=(Number const& y);
  Number& operator-=(Number const& y);
  Number& operator*=(Number const& y);
  /// @throws DivisionByZero  over an exact arithmetic
  Number& operator/=(Number const& y);

  friend Number operator+(Number const& x, Number const& y);
  friend Number operator-(Number const& x, Number const& y);
  friend Number operator*(Number const& x, Number const& y);
  /// @throws DivisionByZero  over an exact arithmetic
  /// @throws Undecided       where the ball of y holds zero
  friend Number operator/(Number const& x, Number const& y);
  friend Number operator-(Number const& x);
  friend Number operator+(Number const& x) { return x; }

  // Over a prime field only 0 and 1, which are sizes, have an order.

  /// @throws NoOrder    over a prime field, but for 0 and 1
  /// @throws Undecided  where the balls of the two meet
  friend bool operator<(Number const& x, Number const& y);
  friend bool operator>(Number const& x, Number const& y) { return y < x; }
  friend bool operator<=(Number const& x, Number const& y);
  friend bool operator>=(Number const& x, Number const& y) { return y <= x; }
  /// @throws Undecided  where the balls of the two meet and are no points
  friend bool operator==(Number const& x, Number const& y);
  friend std::ostream& operator<<(std::ostream& out, Number const& x);

  /// As double, for printing and for choosing; other types see \ref to_double.
  /// @throws NoOrder  over a prime field, but for 0 and 1
  template <std::same_as<double> T>
  T convert_to() const { return as_double(); }
  /// For a message, to nine digits.
  std::string text() const;
  /// Upper bound of the degree as a rational function of the draws; zero outside the prime fields.
  DegreeBound degree() const;
  /// The representative between 0 and p - 1.
  /// @throws NoOrder  outside the prime fields
  std::uint64_t residue() const;
  /// Upper bound for the degrees of the solution of A X = B, numerator and denominator, by Cramer's rule:
  /// rows are cleared of their denominators, and a dual number is a triangular block of plain ones. Zero
  /// outside the prime fields.
  template <class A, class B>
  static double degree_of_solution(A const& a, B const& b) {
    if (current_arithmetic().kind() != ArithmeticKind::prime) return 0;
    double degree = 0;
    for (int i = 0; i < static_cast<int>(a.rows()); ++i) {
      Terms row;
      for (int j = 0; j < static_cast<int>(a.cols()); ++j) row.add(terms_of(a(i, j)));
      for (int j = 0; j < static_cast<int>(b.cols()); ++j) row.add(terms_of(b(i, j)));
      degree += row.denominators + row.excess;
    }
    return degree * levels_of(a(0, 0));
  }
  /// Puts a bound in place of those that are larger.
  template <class X>
  static void bound_degrees(X& x, double degree) {
    if (current_arithmetic().kind() != ArithmeticKind::prime) return;
    for (int i = 0; i < static_cast<int>(x.rows()); ++i)
      for (int j = 0; j < static_cast<int>(x.cols()); ++j) bound(x(i, j), degree);
  }
  /// A number that is not larger, and one that is not smaller, rounded to the arithmetic's digits; both the
  /// number itself but for a ball.
  Number lower() const;
  Number upper() const;  ///< see lower()
  /// Whether a ball holds zero; elsewhere whether the number is zero.
  bool holds_zero() const;
  /// A ball that holds every number from the least of one to the largest of the other.
  /// @throws Error  in another arithmetic than that of balls
  static Number between(Number const& from, Number const& to);

 private:
  friend struct detail::NumberParts;
  // What the two words hold. A negative mark: a pointer to a cell, and its kind. Else:
  //   hardware       the double, 0
  //   prime          the representative, a DegreeBound
  //   rational       the numerator, the denominator less one
  //   decimal, ball  a whole number below 2^53 in size, 0
  // In each of them two words of zero are the number zero.
  std::int64_t word_, mark_;

  // Of the coefficients of a scalar: the degrees of their denominators together, and by how much a numerator
  // is above its denominator at most.
  struct Terms {
    double denominators = 0, excess = 0;
    void add(Terms const& other) {
      denominators += other.denominators;
      if (other.excess > excess) excess = other.excess;
    }
  };
  static Terms terms_of(Number const& x) {
    DegreeBound const d = x.degree();
    return {d.denominator, d.numerator > d.denominator ? d.numerator - d.denominator : 0.0};
  }
  template <class D>
  static Terms terms_of(D const& x) {
    if constexpr (is_dual<D>) {
      Terms all = terms_of(x.value), part;
      for (auto const& p : x.part) {
        Terms const one = terms_of(p);
        if (one.denominators > part.denominators) part.denominators = one.denominators;
        if (one.excess > part.excess) part.excess = one.excess;
      }
      all.add(part);
      return all;
    } else {
      return {std::numeric_limits<double>::infinity(), 0};  // another kind of scalar: no bound
    }
  }
  template <class D>
  static int levels_of(D const& x) {
    if constexpr (is_dual<D>)
      return 2 * levels_of(x.value);
    else
      return 1;
  }
  static void bound(Number& x, double degree);
  template <class D>
  static void bound(D& x, double degree) {
    if constexpr (is_dual<D>) {
      bound(x.value, degree);
      for (auto& p : x.part) bound(p, degree);
    }
  }

  void set_whole(std::int64_t n);
  void set_double(double x);
  void copy_cell(Number const& x);
  void assign_cell(Number const& x);
  void release_cell() noexcept;
  double as_double() const;
  static Number field_draw(std::uint64_t residue);
};

/// A division by zero over an exact arithmetic.
struct DivisionByZero : Error {
  DivisionByZero() : Error("division by zero: draw other numbers") {}
};

void add_product(Number& z, Number const& x, Number const& y);

// Functions. Over the fields that have none they throw NotInThisField; roots exist there of squares.

/// \f$\sqrt x\f$. Over the rationals that of a square; modulo p = 3 mod 4 the root that is itself a square.
/// @throws NotASquare      over an exact arithmetic where x is none
/// @throws NotInThisField  modulo a prime that is 1 mod 4
Number sqrt(Number const& x);
/// @throws NotInThisField  over an exact arithmetic, as those that follow
Number exp(Number const& x);
Number log(Number const& x);
Number sin(Number const& x);
Number cos(Number const& x);
Number tan(Number const& x);
Number asin(Number const& x);
Number acos(Number const& x);
Number atan(Number const& x);
Number sinh(Number const& x);
Number cosh(Number const& x);
Number tanh(Number const& x);
/// The angle of the point (x, y).
Number atan2(Number const& y, Number const& x);
/// \f$x^e\f$; over an exact arithmetic for whole e.
Number pow(Number const& x, Number const& exponent);
Number abs(Number const& x);
/// The binary exponent of a number within the range of double, and the number over that power of two.
Number frexp(Number const& x, int* exponent);
/// \f$2^nx\f$.
Number ldexp(Number const& x, int n);
/// The size of a number: over a prime field 0 or 1; of a ball the largest modulus in it.
Number magnitude(Number const& x);
bool is_finite(Number const& x);
inline bool isfinite(Number const& x) { return is_finite(x); }
inline Number square_root(Number const& x) { return sqrt(x); }

static_assert(sizeof(Number) == 16);

}  // namespace actio

/// What is asked of a scalar's limits, at run time.
template <>
struct std::numeric_limits<actio::Number> {
  static constexpr bool is_specialized = true, is_signed = true, is_integer = false;
  static constexpr int max_exponent = 0;  // what Boost's numbers ask of others: of no kind that they know
  static actio::Number epsilon() { return actio::Number::rounding(); }
  static actio::Number infinity() { return actio::Number(std::numeric_limits<double>::infinity()); }
  static actio::Number quiet_NaN() { return actio::Number(std::numeric_limits<double>::quiet_NaN()); }
  static actio::Number min() { return actio::Number(std::numeric_limits<double>::min()); }
};

#include "witness/compiled_numbers.hpp"
