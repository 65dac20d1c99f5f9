#include "actio/formula/tape_builder.hpp"

namespace actio {

/// The constant factor of an entry that is no constant.
TapeBuilder::Multiple TapeBuilder::multiple(Entry e) {
  if (is_constant(e)) return {std::nullopt, e};
  if (operation(e) == Operation::negate) return {number(-1), first(e)};
  if (operation(e) == Operation::multiply && is_constant(first(e))) return {first(e), second(e)};
  return {std::nullopt, e};
}

/// An operation on two constants: a ratio where it fits.
TapeBuilder::Entry TapeBuilder::folded(Operation operation, Entry a, Entry b) {
  ExactRatio const *x = ratio_of(a), *y = ratio_of(b);
  std::optional<ExactRatio> result;
  if (x && y) {
    if (operation == Operation::add) result = sum(*x, *y);
    if (operation == Operation::subtract) result = sum(*x, -*y);
    if (operation == Operation::multiply) result = product(*x, *y);
    if (operation == Operation::divide && !is(b, 0)) result = product(*x, *reciprocal(*y));
  }
  return result ? number(*result) : entry(operation, a, b);
}

/// \f$cx \pm dx = (c \pm d)x\f$.
std::optional<TapeBuilder::Entry> TapeBuilder::collected(Operation sign, Entry a, Entry b) {
  if (is_constant(a) || is_constant(b)) return std::nullopt;
  Multiple const x = multiple(a), y = multiple(b);
  if (x.rest != y.rest) return std::nullopt;
  return multiply(folded(sign, factor_of(x), factor_of(y)), x.rest);
}

TapeBuilder::Entry TapeBuilder::add(Entry a, Entry b) {
  if (is(a, 0)) return b;
  if (is(b, 0)) return a;
  if (is_constant(a) && is_constant(b)) return folded(Operation::add, a, b);
  if (auto const one = collected(Operation::add, a, b)) return *one;
  if (operation(b) == Operation::negate) return subtract(a, first(b));
  if (operation(a) == Operation::negate) return subtract(b, first(a));
  return entry(Operation::add, a, b);
}

TapeBuilder::Entry TapeBuilder::subtract(Entry a, Entry b) {
  if (is(b, 0)) return a;
  if (is(a, 0)) return negate(b);
  if (is_constant(a) && is_constant(b)) return folded(Operation::subtract, a, b);
  if (auto const one = collected(Operation::subtract, a, b)) return *one;
  if (operation(b) == Operation::negate) return add(a, first(b));
  if (operation(a) == Operation::negate) return negate(add(first(a), b));
  return entry(Operation::subtract, a, b);
}

TapeBuilder::Entry TapeBuilder::negate(Entry a) {
  if (auto const* x = ratio_of(a)) return number(-*x);
  if (operation(a) == Operation::negate) return first(a);
  if (operation(a) == Operation::subtract) return subtract(second(a), first(a));
  Multiple const x = multiple(a);
  return x.factor ? multiply(negate(*x.factor), x.rest) : entry(Operation::negate, a);
}

TapeBuilder::Entry TapeBuilder::multiply(Entry a, Entry b) {
  if (is_constant(b)) std::swap(a, b);
  if (is(a, 0)) return a;
  if (is(a, 1)) return b;
  if (is_constant(b)) return folded(Operation::multiply, a, b);
  // Constant factors to the front.
  Multiple const x = multiple(a), y = multiple(b);
  if (is_constant(a)) {
    if (is(a, -1)) return negate(b);
    auto const both = y.factor ? in_range(multiply(a, *y.factor)) : std::nullopt;
    return both ? multiply(*both, y.rest) : entry(Operation::multiply, a, b);
  }
  if (!x.factor && !y.factor) {
    if (is_reciprocal(b)) return divide(a, second(b));
    return is_reciprocal(a) ? divide(b, second(a)) : entry(Operation::multiply, a, b);
  }
  auto const both = in_range(multiply(factor_of(x), factor_of(y)));
  return both ? multiply(*both, multiply(x.rest, y.rest)) : entry(Operation::multiply, a, b);
}

TapeBuilder::Entry TapeBuilder::divide(Entry a, Entry b) {
  if (is_constant(a) && is_constant(b)) return folded(Operation::divide, a, b);
  if (is(a, 0)) return a;
  if (is_constant(b)) {
    auto const inverse = in_range(folded(Operation::divide, number(1), b));
    return inverse ? multiply(*inverse, a) : entry(Operation::divide, a, b);
  }
  // Constant factors to the front.
  Multiple const x = is_constant(a) ? Multiple{a, number(1)} : multiple(a), y = multiple(b);
  if (!y.factor && (!x.factor || is_constant(a))) return entry(Operation::divide, a, b);
  auto const both = in_range(divide(factor_of(x), factor_of(y)));
  if (!both) return entry(Operation::divide, a, b);
  return is_constant(a) ? divide(*both, y.rest) : multiply(*both, divide(x.rest, y.rest));
}

TapeBuilder::Entry TapeBuilder::whole_power(Entry a, int n) {
  if (n < 0) return divide(number(1), whole_power(a, -n));
  if (n < 2) return n == 1 ? a : number(1);
  Entry const root = whole_power(a, n / 2), square = multiply(root, root);
  return n % 2 ? multiply(square, a) : square;
}

TapeBuilder::Entry TapeBuilder::power(Entry a, Entry b) {
  constexpr int most = 64;
  if (auto const* e = ratio_of(b)) {
    if (e->whole() && -most <= e->above && e->above <= most)
      return whole_power(a, static_cast<int>(e->above));
    if (*e == ExactRatio{1, 2}) return apply(Operation::sqrt, a);
    if (*e == ExactRatio{-1, 2}) return divide(number(1), apply(Operation::sqrt, a));
  }
  if (is_constant(b)) return entry(Operation::power, a, b);
  return apply(Operation::exp, multiply(b, apply(Operation::log, a)));
}

/// A function of a ratio where it is a ratio again.
std::optional<ExactRatio> TapeBuilder::folded(Operation function, ExactRatio const& x) const {
  switch (function) {
    case Operation::sqrt:
      return exact_root(x);
    case Operation::exp:
    case Operation::cos:
    case Operation::cosh:
      return x.is(0) ? std::optional(ExactRatio{1, 1}) : std::nullopt;
    case Operation::log:
    case Operation::log2:
    case Operation::log10:
    case Operation::acos:
    case Operation::acosh:
      return x.is(1) ? std::optional(ExactRatio{0, 1}) : std::nullopt;
    default:
      return x.is(0) ? std::optional(ExactRatio{0, 1}) : std::nullopt;
  }
}

TapeBuilder::Entry TapeBuilder::as_written(Operation operation, Entry a, Entry b) {
  if (operation == Operation::power)
    for (int n = 2; n <= 4; ++n)
      if (is(b, n)) {
        Entry product = a;
        for (int k = 1; k < n; ++k) product = entry(Operation::multiply, product, a);
        return product;
      }
  return joins_two(operation) ? entry(operation, a, b) : entry(operation, a);
}

TapeBuilder::Entry TapeBuilder::record(Operation operation, Entry a, Entry b) {
  switch (operation) {
    case Operation::pi:
      return pi();
    case Operation::add:
      return add(a, b);
    case Operation::subtract:
      return subtract(a, b);
    case Operation::multiply:
      return multiply(a, b);
    case Operation::divide:
      return divide(a, b);
    case Operation::negate:
      return negate(a);
    case Operation::power:
      return power(a, b);
    default:
      return joins_two(operation) ? apply(operation, a, b) : apply(operation, a);
  }
}

}  // namespace actio
