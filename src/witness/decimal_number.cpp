// Floating point of any precision, by MPFR. Whole numbers below 2^53 in size stand in the number itself.
#include <mpfr.h>

#include <cmath>

#include "witness/free_cells.hpp"

namespace actio::detail {

namespace {

struct Cell {
  mpfr_t value;
  Cell() { mpfr_init2(value, current_arithmetic().bits()); }
  ~Cell() { mpfr_clear(value); }
  /// Takes the precision in force.
  void renew() {
    long const bits = current_arithmetic().bits();
    if (mpfr_get_prec(value) != bits) mpfr_set_prec(value, bits);
  }
  void put(Number const& x) { renew(), mpfr_set_si(value, NumberParts::word(x), MPFR_RNDN); }
};
constexpr mpfr_rnd_t nearest = MPFR_RNDN;

mpfr_ptr value(Number const& x) { return static_cast<Cell*>(NumberParts::cell(x))->value; }
std::int64_t whole(Number const& x) { return NumberParts::word(x); }
bool is_zero(Number const& x) { return !NumberParts::in_cell(x) && whole(x) == 0; }

/// A free cell of the precision in force.
Cell* fresh() {
  Cell* const cell = free_cells<Cell>().take();
  cell->renew();
  return cell;
}
void put(Number& z, Cell* cell) { NumberParts::set(z, reinterpret_cast<std::int64_t>(cell), decimal_cell); }

using Argument = InCell<Cell>;

/// The two operands are whole numbers and so is the result: true where it was put into z.
bool whole_operation(Operation op, Number& z, std::int64_t a, std::int64_t b) {
  constexpr std::int64_t limit = std::int64_t(1) << 53;
  __int128 result = 0;
  switch (op) {
    case Operation::add:
      result = static_cast<__int128>(a) + b;
      break;
    case Operation::subtract:
      result = static_cast<__int128>(a) - b;
      break;
    case Operation::multiply:
      result = static_cast<__int128>(a) * b;
      break;
    default:
      if (b == 0 || a % b != 0) return false;
      result = a / b;
  }
  if (result <= -limit || result >= limit) return false;
  NumberParts::set(z, static_cast<std::int64_t>(result), 0);
  return true;
}

}  // namespace

void decimal_operation(Operation op, Number& z, Number const& x, Number const& y) {
  bool const whole_x = !NumberParts::in_cell(x), whole_y = !NumberParts::in_cell(y);
  if (whole_x && whole_y && whole_operation(op, z, whole(x), whole(y))) return;
  if (op == Operation::add || op == Operation::subtract) {
    if (is_zero(y)) {
      if (&z != &x) z = x;
      return;
    }
    if (is_zero(x) && op == Operation::add) {
      if (&z != &y) z = y;
      return;
    }
  } else if (op == Operation::multiply) {
    if ((is_zero(x) && mpfr_number_p(value(y))) || (is_zero(y) && mpfr_number_p(value(x))))
      return NumberParts::set(z, 0, 0);
  }
  // MPFR may write over its arguments: a cell that z has is used again.
  bool const again = NumberParts::in_cell(z);
  Cell* const cell = again ? static_cast<Cell*>(NumberParts::cell(z)) : fresh();
  mpfr_ptr const out = cell->value;
  // Two whole ones: the first is made one of MPFR's.
  if (whole_x && whole_y) mpfr_set_si(out, whole(x), nearest);
  mpfr_srcptr const first = whole_x ? out : value(x);
  switch (op) {
    case Operation::add:
      whole_y   ? mpfr_add_si(out, first, whole(y), nearest)
      : whole_x ? mpfr_add_si(out, value(y), whole(x), nearest)
                : mpfr_add(out, first, value(y), nearest);
      break;
    case Operation::subtract:
      whole_y   ? mpfr_sub_si(out, first, whole(y), nearest)
      : whole_x ? mpfr_si_sub(out, whole(x), value(y), nearest)
                : mpfr_sub(out, first, value(y), nearest);
      break;
    case Operation::multiply:
      whole_y   ? mpfr_mul_si(out, first, whole(y), nearest)
      : whole_x ? mpfr_mul_si(out, value(y), whole(x), nearest)
                : mpfr_mul(out, first, value(y), nearest);
      break;
    default:
      whole_y   ? mpfr_div_si(out, first, whole(y), nearest)
      : whole_x ? mpfr_si_div(out, whole(x), value(y), nearest)
                : mpfr_div(out, first, value(y), nearest);
  }
  if (!again) put(z, cell);
}

Number decimal_function(Function f, Number const& x) {
  // In the order of Function.
  constexpr decltype(&mpfr_sqrt) functions[] = {mpfr_sqrt, mpfr_exp,  mpfr_log,  mpfr_sin,
                                                mpfr_cos,  mpfr_tan,  mpfr_asin, mpfr_acos,
                                                mpfr_atan, mpfr_sinh, mpfr_cosh, mpfr_tanh};
  Argument const of(x);
  Cell* const cell = fresh();
  functions[static_cast<int>(f)](cell->value, of.at, nearest);
  Number z;
  put(z, cell);
  return z;
}
Number decimal_pow(Number const& x, Number const& exponent) {
  Argument const base(x), e(exponent);
  Cell* const cell = fresh();
  mpfr_pow(cell->value, base.at, e.at, nearest);
  Number z;
  put(z, cell);
  return z;
}
Number decimal_atan2(Number const& y, Number const& x) {
  Argument const up(y), along(x);
  Cell* const cell = fresh();
  mpfr_atan2(cell->value, up.at, along.at, nearest);
  Number z;
  put(z, cell);
  return z;
}

bool decimal_less(Number const& x, Number const& y, bool or_equal) {
  if (!NumberParts::in_cell(x) && !NumberParts::in_cell(y))
    return or_equal ? whole(x) <= whole(y) : whole(x) < whole(y);
  Argument const a(x), b(y);
  return (or_equal ? mpfr_lessequal_p(a.at, b.at) : mpfr_less_p(a.at, b.at)) != 0;
}
bool decimal_equal(Number const& x, Number const& y) {
  if (!NumberParts::in_cell(x) && !NumberParts::in_cell(y)) return whole(x) == whole(y);
  Argument const a(x), b(y);
  return mpfr_equal_p(a.at, b.at) != 0;
}

void decimal_from_double(Number& z, double x) {
  Cell* const cell = fresh();
  mpfr_set_d(cell->value, x, nearest);
  put(z, cell);
}
void decimal_from_large(Number& z, std::int64_t n) {
  Cell* const cell = fresh();
  mpfr_set_si(cell->value, n, nearest);
  put(z, cell);
}
double decimal_to_double(Number const& x) {
  return NumberParts::in_cell(x) ? mpfr_get_d(value(x), nearest) : static_cast<double>(whole(x));
}
bool decimal_is_finite(Number const& x) { return !NumberParts::in_cell(x) || mpfr_number_p(value(x)) != 0; }

void* copied_decimal(void const* cell) {
  Cell* const copy = fresh();
  mpfr_set(copy->value, static_cast<Cell const*>(cell)->value, nearest);
  return copy;
}
void release_decimal(void* cell) noexcept { free_cells<Cell>().give(static_cast<Cell*>(cell)); }

}  // namespace actio::detail
