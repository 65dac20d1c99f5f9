// The inside of a Number, for the files that compute with it.
#pragma once

#include <bit>
#include <cstdint>

#include "witness/number.hpp"

namespace actio::detail {

/// What the mark of a number that stands in a cell says.
enum Mark : std::int64_t {
  decimal_cell = -1,   ///< an mpfr_t
  rational_cell = -2,  ///< an mpq_t
  ball_cell = -3       ///< an arb_t
};

/// Access to the two words of a number.
struct NumberParts {
  static std::int64_t word(Number const& x) { return x.word_; }
  static std::int64_t mark(Number const& x) { return x.mark_; }
  static bool in_cell(Number const& x) { return x.mark_ < 0; }
  static void* cell(Number const& x) { return reinterpret_cast<void*>(x.word_); }
  /// Puts two words in place of what stood there.
  static void set(Number& x, std::int64_t word, std::int64_t mark) {
    if (x.mark_ < 0) x.release_cell();
    x.word_ = word, x.mark_ = mark;
  }
  static Number made(std::int64_t word, std::int64_t mark) {
    Number x;
    x.word_ = word, x.mark_ = mark;
    return x;
  }
  static void set_double(Number& x, double value) { set(x, std::bit_cast<std::int64_t>(value), 0); }
  static double hardware(Number const& x) { return std::bit_cast<double>(x.word_); }
  static std::uint64_t residue(Number const& x) { return static_cast<std::uint64_t>(x.word_); }
  static DegreeBound degree(Number const& x) { return std::bit_cast<DegreeBound>(x.mark_); }
  static std::int64_t mark_of(DegreeBound const& d) { return std::bit_cast<std::int64_t>(d); }
};

/// The four operations of the arithmetics whose numbers may stand in cells: z is x op y, and may be one of
/// them.
enum class Operation { add, subtract, multiply, divide };

void rational_operation(Operation op, Number& z, Number const& x, Number const& y);
void decimal_operation(Operation op, Number& z, Number const& x, Number const& y);
void ball_operation(Operation op, Number& z, Number const& x, Number const& y);

/// Functions of one argument that all rounded arithmetics have.
enum class Function { sqrt, exp, log, sin, cos, tan, asin, acos, atan, sinh, cosh, tanh };

Number decimal_function(Function f, Number const& x);
Number ball_function(Function f, Number const& x);
Number rational_root(Number const& x);

Number decimal_pow(Number const& x, Number const& exponent);
Number ball_pow(Number const& x, Number const& exponent);
Number decimal_atan2(Number const& y, Number const& x);
Number ball_atan2(Number const& y, Number const& x);

int rational_sign(Number const& x);
int rational_compare(Number const& x, Number const& y);
bool decimal_less(Number const& x, Number const& y, bool or_equal);
bool decimal_equal(Number const& x, Number const& y);
bool ball_less(Number const& x, Number const& y, bool or_equal);
bool ball_equal(Number const& x, Number const& y);

void rational_from_double(Number& z, double x);
void decimal_from_double(Number& z, double x);
void ball_from_double(Number& z, double x);
void rational_from_large(Number& z, std::int64_t n);
void decimal_from_large(Number& z, std::int64_t n);
void ball_from_large(Number& z, std::int64_t n);

double rational_to_double(Number const& x);
double decimal_to_double(Number const& x);
double ball_to_double(Number const& x);
bool decimal_is_finite(Number const& x);
bool ball_is_finite(Number const& x);
Number ball_bound(Number const& x, bool upper);
Number ball_magnitude(Number const& x);
bool ball_holds_zero(Number const& x);
Number ball_between(Number const& from, Number const& to);

void* copied_rational(void const* cell);
void* copied_decimal(void const* cell);
void* copied_ball(void const* cell);
void release_rational(void* cell) noexcept;
void release_decimal(void* cell) noexcept;
void release_ball(void* cell) noexcept;

/// How many cells were ever allocated.
inline std::uint64_t cells_made = 0;

}  // namespace actio::detail
