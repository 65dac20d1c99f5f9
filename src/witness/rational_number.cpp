// Rational numbers: two 64-bit integers where these suffice, GMP's where they do not.
#include <gmp.h>
#include <mpfr.h>

#include <cmath>
#include <cstdlib>
#include <numeric>

#include "actio/numbers/square_root.hpp"
#include "witness/free_cells.hpp"

namespace actio::detail {

namespace {

using Wide = __int128;

struct Cell {
  mpq_t value;
  Cell() { mpq_init(value); }
  ~Cell() { mpq_clear(value); }
  void put(Number const& x) {
    mpq_set_si(value, NumberParts::word(x), static_cast<unsigned long>(NumberParts::mark(x) + 1));
  }
};

constexpr std::int64_t largest = INT64_MAX;
bool fits(Wide const& x) { return x >= -largest && x <= largest; }
std::int64_t size_of(std::int64_t x) { return x < 0 ? -x : x; }
std::int64_t numerator(Number const& x) { return NumberParts::word(x); }
std::int64_t denominator(Number const& x) { return NumberParts::mark(x) + 1; }
mpq_ptr value(Number const& x) { return static_cast<Cell*>(NumberParts::cell(x))->value; }

void set_small(Number& z, std::int64_t n, std::int64_t d) { NumberParts::set(z, n, d - 1); }

/// The number of a cell becomes a small one where it fits.
void settle(Number& z, Cell* cell) {
  mpz_ptr const n = mpq_numref(cell->value), d = mpq_denref(cell->value);
  if (mpz_fits_slong_p(n) && mpz_fits_slong_p(d) && mpz_get_si(n) != INT64_MIN) {
    set_small(z, mpz_get_si(n), mpz_get_si(d));
    free_cells<Cell>().give(cell);
  } else {
    NumberParts::set(z, reinterpret_cast<std::int64_t>(cell), rational_cell);
  }
}
void set_wide(mpz_ptr z, Wide const& x) {
  bool const negative = x < 0;
  unsigned __int128 const size =
      negative ? -static_cast<unsigned __int128>(x) : static_cast<unsigned __int128>(x);
  mpz_set_ui(z, static_cast<std::uint64_t>(size >> 64));
  mpz_mul_2exp(z, z, 64);
  mpz_add_ui(z, z, static_cast<std::uint64_t>(size));
  if (negative) mpz_neg(z, z);
}
/// A fraction in lowest terms.
void set_fraction(Number& z, Wide const& n, Wide const& d) {
  if (fits(n) && fits(d)) return set_small(z, static_cast<std::int64_t>(n), static_cast<std::int64_t>(d));
  Cell* const cell = free_cells<Cell>().take();
  set_wide(mpq_numref(cell->value), n);
  set_wide(mpq_denref(cell->value), d);
  NumberParts::set(z, reinterpret_cast<std::int64_t>(cell), rational_cell);
}

/// a/b + c/d, Knuth's way: only small numbers have their divisors looked for.
void add_small(Number& z, std::int64_t a, std::int64_t b, std::int64_t c, std::int64_t d) {
  if (b == 1 && d == 1) return set_fraction(z, Wide(a) + c, 1);
  std::int64_t const g = std::gcd(b, d);
  if (g == 1) return set_fraction(z, Wide(a) * d + Wide(c) * b, Wide(b) * d);
  Wide const t = Wide(a) * (d / g) + Wide(c) * (b / g);
  std::int64_t const rest = static_cast<std::int64_t>(t % g);
  std::int64_t const h = rest == 0 ? g : std::gcd(rest, g);
  set_fraction(z, t / h, Wide(b / g) * (d / h));
}
void multiply_small(Number& z, std::int64_t a, std::int64_t b, std::int64_t c, std::int64_t d) {
  if (a == 0 || c == 0) return set_small(z, 0, 1);
  std::int64_t const g = d == 1 ? 1 : std::gcd(size_of(a), d), h = b == 1 ? 1 : std::gcd(size_of(c), b);
  set_fraction(z, Wide(a / g) * (c / h), Wide(b / h) * (d / g));
}

using Argument = InCell<Cell>;

}  // namespace

void rational_operation(Operation op, Number& z, Number const& x, Number const& y) {
  if (op == Operation::divide && rational_sign(y) == 0) throw DivisionByZero();
  if (!NumberParts::in_cell(x) && !NumberParts::in_cell(y)) {
    std::int64_t const a = numerator(x), b = denominator(x), c = numerator(y), d = denominator(y);
    switch (op) {
      case Operation::add:
        return add_small(z, a, b, c, d);
      case Operation::subtract:
        return add_small(z, a, b, -c, d);
      case Operation::multiply:
        return multiply_small(z, a, b, c, d);
      default:
        return multiply_small(z, a, b, c < 0 ? -d : d, size_of(c));
    }
  }
  Argument const left(x), right(y);
  Cell* const cell = free_cells<Cell>().take();
  // In the order of Operation.
  constexpr decltype(&mpq_add) operations[] = {mpq_add, mpq_sub, mpq_mul, mpq_div};
  operations[static_cast<int>(op)](cell->value, left.at, right.at);
  settle(z, cell);
}

int rational_sign(Number const& x) {
  if (NumberParts::in_cell(x)) return mpq_sgn(value(x));
  std::int64_t const n = numerator(x);
  return (n > 0) - (n < 0);
}
int rational_compare(Number const& x, Number const& y) {
  if (!NumberParts::in_cell(x) && !NumberParts::in_cell(y)) {
    Wide const left = Wide(numerator(x)) * denominator(y), right = Wide(numerator(y)) * denominator(x);
    return (left > right) - (left < right);
  }
  Argument const left(x), right(y);
  return mpq_cmp(left.at, right.at);
}

void rational_from_double(Number& z, double x) {
  Cell* const cell = free_cells<Cell>().take();
  mpq_set_d(cell->value, x);
  settle(z, cell);
}
void rational_from_large(Number& z, std::int64_t n) {
  Cell* const cell = free_cells<Cell>().take();
  mpq_set_si(cell->value, n, 1);
  settle(z, cell);
}
double rational_to_double(Number const& x) {
  if (!NumberParts::in_cell(x) && denominator(x) == 1) return static_cast<double>(numerator(x));
  mpfr_t nearest;
  mpfr_init2(nearest, 53);
  mpfr_set_q(nearest, Argument(x).at, MPFR_RNDN);
  double const result = mpfr_get_d(nearest, MPFR_RNDN);
  mpfr_clear(nearest);
  return result;
}

Number rational_root(Number const& x) {
  Argument const square(x);
  if (mpq_sgn(square.at) < 0 || !mpz_perfect_square_p(mpq_numref(square.at)) ||
      !mpz_perfect_square_p(mpq_denref(square.at)))
    throw NotASquare("sqrt", "the square of a rational number is needed over the rationals",
                     rational_to_double(x), 0);
  Cell* const cell = free_cells<Cell>().take();
  mpz_sqrt(mpq_numref(cell->value), mpq_numref(square.at));
  mpz_sqrt(mpq_denref(cell->value), mpq_denref(square.at));
  Number root;
  settle(root, cell);
  return root;
}

void* copied_rational(void const* cell) {
  Cell* const copy = free_cells<Cell>().take();
  mpq_set(copy->value, static_cast<Cell const*>(cell)->value);
  return copy;
}
void release_rational(void* cell) noexcept { free_cells<Cell>().give(static_cast<Cell*>(cell)); }

}  // namespace actio::detail
