// Balls, by Arb: a centre and a radius that holds every error. Whole numbers below 2^53 in size stand in the
// number itself.
#include <arb.h>

#include <cmath>

#include "witness/free_cells.hpp"

namespace actio::detail {

namespace {

struct Cell {
  arb_t value;
  Cell() { arb_init(value); }
  ~Cell() { arb_clear(value); }
  void put(Number const& x) { arb_set_si(value, NumberParts::word(x)); }
};

arb_ptr value(Number const& x) { return static_cast<Cell*>(NumberParts::cell(x))->value; }
std::int64_t whole(Number const& x) { return NumberParts::word(x); }
slong precision() { return current_arithmetic().bits(); }
void put(Number& z, Cell* cell) { NumberParts::set(z, reinterpret_cast<std::int64_t>(cell), ball_cell); }

using Argument = InCell<Cell>;

[[noreturn]] void undecided(char const* question) {
  throw Undecided(std::string(question) + ": balls of " + std::to_string(current_arithmetic().digits()) +
                  " digits do not tell; ask for more digits");
}

}  // namespace

void ball_operation(Operation op, Number& z, Number const& x, Number const& y) {
  bool const whole_x = !NumberParts::in_cell(x), whole_y = !NumberParts::in_cell(y);
  constexpr std::int64_t limit = std::int64_t(1) << 53;
  if (whole_x && whole_y && op != Operation::divide) {
    __int128 const a = whole(x), b = whole(y),
                   result = op == Operation::add        ? a + b
                            : op == Operation::subtract ? a - b
                                                        : a * b;
    if (result > -limit && result < limit) return NumberParts::set(z, static_cast<std::int64_t>(result), 0);
  }
  if (whole_y && whole(y) == 0 && (op == Operation::add || op == Operation::subtract)) {
    if (&z != &x) z = x;
    return;
  }
  if (op == Operation::multiply && ((whole_x && whole(x) == 0 && arb_is_finite(value(y))) ||
                                    (whole_y && whole(y) == 0 && arb_is_finite(value(x)))))
    return NumberParts::set(z, 0, 0);
  if (op == Operation::divide) {
    if (whole_y && whole(y) == 0) throw DivisionByZero();
    if (!whole_y && arb_contains_zero(value(y))) undecided("whether a divisor vanishes");
  }
  Argument const a(x), b(y);
  Cell* const cell = free_cells<Cell>().take();
  // In the order of Operation.
  constexpr decltype(&arb_add) operations[] = {arb_add, arb_sub, arb_mul, arb_div};
  operations[static_cast<int>(op)](cell->value, a.at, b.at, precision());
  put(z, cell);
}

Number ball_function(Function f, Number const& x) {
  // In the order of Function.
  constexpr decltype(&arb_sqrt) functions[] = {arb_sqrt, arb_exp,  arb_log,  arb_sin,  arb_cos,  arb_tan,
                                               arb_asin, arb_acos, arb_atan, arb_sinh, arb_cosh, arb_tanh};
  Argument const of(x);
  Cell* const cell = free_cells<Cell>().take();
  functions[static_cast<int>(f)](cell->value, of.at, precision());
  Number z;
  put(z, cell);
  return z;
}
Number ball_pow(Number const& x, Number const& exponent) {
  Argument const base(x), e(exponent);
  Cell* const cell = free_cells<Cell>().take();
  arb_pow(cell->value, base.at, e.at, precision());
  Number z;
  put(z, cell);
  return z;
}
Number ball_atan2(Number const& y, Number const& x) {
  Argument const up(y), along(x);
  Cell* const cell = free_cells<Cell>().take();
  arb_atan2(cell->value, up.at, along.at, precision());
  Number z;
  put(z, cell);
  return z;
}

bool ball_less(Number const& x, Number const& y, bool or_equal) {
  if (!NumberParts::in_cell(x) && !NumberParts::in_cell(y))
    return or_equal ? whole(x) <= whole(y) : whole(x) < whole(y);
  if (&x == &y) return or_equal && ball_is_finite(x);
  Argument const a(x), b(y);
  if (or_equal ? arb_le(a.at, b.at) : arb_lt(a.at, b.at)) return true;
  if (or_equal ? arb_gt(a.at, b.at) : arb_ge(a.at, b.at)) return false;
  undecided("which of two numbers is the larger");
}
bool ball_equal(Number const& x, Number const& y) {
  if (!NumberParts::in_cell(x) && !NumberParts::in_cell(y)) return whole(x) == whole(y);
  if (&x == &y) return ball_is_finite(x);
  Argument const a(x), b(y);
  if (arb_eq(a.at, b.at)) return true;
  if (arb_ne(a.at, b.at)) return false;
  undecided("whether two numbers are equal");
}

void ball_from_double(Number& z, double x) {
  Cell* const cell = free_cells<Cell>().take();
  arb_set_d(cell->value, x);
  put(z, cell);
}
void ball_from_large(Number& z, std::int64_t n) {
  Cell* const cell = free_cells<Cell>().take();
  arb_set_si(cell->value, n);
  put(z, cell);
}
double ball_to_double(Number const& x) {
  return NumberParts::in_cell(x) ? arf_get_d(arb_midref(value(x)), ARF_RND_NEAR)
                                 : static_cast<double>(whole(x));
}
bool ball_is_finite(Number const& x) { return !NumberParts::in_cell(x) || arb_is_finite(value(x)); }
bool ball_holds_zero(Number const& x) {
  return NumberParts::in_cell(x) ? arb_contains_zero(value(x)) : whole(x) == 0;
}

Number ball_between(Number const& from, Number const& to) {
  Argument const a(from), b(to);
  Cell* const cell = free_cells<Cell>().take();
  arb_union(cell->value, a.at, b.at, precision());
  Number z;
  put(z, cell);
  return z;
}

Number ball_bound(Number const& x, bool upper) {
  Argument const of(x);
  Cell* const cell = free_cells<Cell>().take();
  mag_zero(arb_radref(cell->value));
  if (upper)
    arb_get_ubound_arf(arb_midref(cell->value), of.at, precision());
  else
    arb_get_lbound_arf(arb_midref(cell->value), of.at, precision());
  Number z;
  put(z, cell);
  return z;
}
Number ball_magnitude(Number const& x) {
  if (!NumberParts::in_cell(x)) return NumberParts::made(std::abs(whole(x)), 0);
  Cell* const cell = free_cells<Cell>().take();
  mag_zero(arb_radref(cell->value));
  arb_get_abs_ubound_arf(arb_midref(cell->value), value(x), precision());
  Number z;
  put(z, cell);
  return z;
}

void* copied_ball(void const* cell) {
  Cell* const copy = free_cells<Cell>().take();
  arb_set(copy->value, static_cast<Cell const*>(cell)->value);
  return copy;
}
void release_ball(void* cell) noexcept { free_cells<Cell>().give(static_cast<Cell*>(cell)); }

}  // namespace actio::detail
