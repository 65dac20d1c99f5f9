// The functions that a formula calls, over every scalar, and their derivatives.
//
// Their derivatives are written once, over scalars and over the terms that a tape is recorded with: dual
// numbers and the differentiated tape share them.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "actio/formula/operation.hpp"
#include "actio/numbers/dual.hpp"
#include "actio/numbers/errors.hpp"
#include "actio/numbers/square_root.hpp"

namespace actio {

namespace detail {
/// Refuses an operation with kinks or jumps: it has values over double, and no derivatives.
[[noreturn]] inline void refuse_kinks(Operation operation) {
  throw Error("'" + std::string(name_of(operation)) +
              "' has kinks or jumps: in a formula it has values in double precision, and no derivatives");
}
/// A function over double.
double function_of_double(Operation operation, double x);

/// A function over any other field with roots, exponentials and angles: made of these six.
template <class S>
S function_of_six(Operation operation, S const& x) {
  S const one(1);
  switch (operation) {
    case Operation::sqrt:
      return sqrt(x);
    case Operation::exp:
      return exp(x);
    case Operation::log:
      return log(x);
    case Operation::sin:
      return sin(x);
    case Operation::cos:
      return cos(x);
    case Operation::cbrt: {
      if (x < S(0)) return -function_of_six(operation, S(-x));
      return x > S(0) ? S(exp(S(log(x) / S(3)))) : x;
    }
    case Operation::log2:
      return log(x) / log(S(2));
    case Operation::log10:
      return log(x) / log(S(10));
    case Operation::tan:
      return sin(x) / cos(x);
    case Operation::asin:
      return atan2(x, S(sqrt(S((one - x) * (one + x)))));
    case Operation::acos:
      return atan2(S(sqrt(S((one - x) * (one + x)))), x);
    case Operation::atan:
      return atan2(x, one);
    case Operation::sinh: {
      S const e = exp(x);
      return (e - one / e) / S(2);
    }
    case Operation::cosh: {
      S const e = exp(x);
      return (e + one / e) / S(2);
    }
    case Operation::tanh: {
      if (x < S(0)) return -function_of_six(operation, S(-x));
      S const e = exp(S(x * S(-2)));
      return (one - e) / (one + e);
    }
    case Operation::asinh: {
      if (x < S(0)) return -function_of_six(operation, S(-x));
      return log(S(x + sqrt(S(x * x + one))));
    }
    case Operation::acosh:
      return log(S(x + sqrt(S((x - one) * (x + one)))));
    case Operation::atanh:
      return log(S((one + x) / (one - x))) / S(2);
    default:
      refuse_kinks(operation);
  }
}

/// A function of two numbers with kinks or jumps, over double.
inline double kinked_function(Operation operation, double x, double y) {
  switch (operation) {
    case Operation::less:
      return x < y;
    case Operation::at_most:
      return x <= y;
    case Operation::equal:
      return x == y;
    case Operation::unequal:
      return x != y;
    case Operation::both:
      return x != 0 && y != 0;
    case Operation::either:
      return x != 0 || y != 0;
    case Operation::where:
      return x != 0 ? y : -0.0;
    case Operation::unless:
      return x != 0 ? -0.0 : y;
    case Operation::min:
      return std::min(x, y);
    default:
      return std::max(x, y);
  }
}

/// Refuses what the rationals do not hold.
[[noreturn]] inline void refuse_over_rationals(Operation operation, double x) {
  throw NotInThisField("'" + std::string(name_of(operation)) + "' in a formula over the rationals",
                       "only + - * /, powers with whole exponents up to 64 and roots of squares are rational",
                       x, 0);
}
}  // namespace detail

/// A function of one number, of a plain number. Outside of its domain it is a NaN.
/// @throws NotInThisField  over the rationals, unless it is the root of a square
template <Plain S>
S elementary(Operation operation, S const& x) {
  if constexpr (std::same_as<S, double>) {
    return detail::function_of_double(operation, x);
  } else if constexpr (is_exact<S>) {
    if (operation != Operation::sqrt) detail::refuse_over_rationals(operation, to_double(x));
    return square_root(x);
  } else {
    return detail::function_of_six(operation, x);
  }
}

/// A function of one number, applied to a dual number: the chain rule.
template <class S, int N>
Dual<S, N> elementary(Operation operation, Dual<S, N> const& x);
/// A function of one number, applied to a power series or the like.
template <class S>
  requires(!Plain<S>)
S elementary(Operation operation, S const& x) {
  return detail::function_of_six(operation, x);
}

/// \f$x^c\f$ with a constant c, of plain numbers.
template <Plain S>
S power(S const& x, S const& c) {
  if constexpr (is_exact<S>) {
    detail::refuse_over_rationals(Operation::power, to_double(c));
  } else if constexpr (std::same_as<S, double>) {
    return std::pow(x, c);
  } else {
    return pow(x, c);
  }
}
/// \f$x^c\f$ with a constant c, of power series and the like.
template <class S>
  requires(!Plain<S>)
S power(S const& x, S const& c) {
  using std::exp, std::log;
  return exp(S(c * log(x)));
}
/// \f$x^c\f$ with a constant c, of dual numbers: c has no rates.
template <class S, int N>
Dual<S, N> power(Dual<S, N> const& x, Dual<S, N> const& c) {
  return chain(x, S(power(x.value, c.value)), S(c.value * power(x.value, S(c.value - 1))));
}

/// \f$\sqrt{x^2 + y^2}\f$.
template <class S>
S hypotenuse(S const& x, S const& y) {
  if constexpr (std::same_as<S, double>)
    return std::hypot(x, y);
  else
    return elementary(Operation::sqrt, S(x * x + y * y));
}
/// \f$\sqrt{x^2 + y^2}\f$ of dual numbers.
template <class S, int N>
Dual<S, N> hypotenuse(Dual<S, N> const& x, Dual<S, N> const& y) {
  Dual<S, N> r(S(hypotenuse(x.value, y.value)));
  S const along_x = x.value / r.value, along_y = y.value / r.value;
  for (int a = 0; a < N; ++a) r.part[a] = along_x * x.part[a] + along_y * y.part[a];
  return r;
}

/// The angle of the point (x, y), as the library has it; the rationals do not hold it.
template <class S>
S angle_of(S const& y, S const& x) {
  if constexpr (is_exact<S>) {
    detail::refuse_over_rationals(Operation::atan2, to_double(y));
  } else {
    using std::atan2;
    return atan2(y, x);
  }
}

/// A function of two numbers with kinks or jumps.
/// @throws Error  over anything but double
template <class S>
S kinked(Operation operation, S const& x, S const& y) {
  if constexpr (std::same_as<S, double>)
    return detail::kinked_function(operation, x, y);
  else
    detail::refuse_kinks(operation);
}

/// A function of two numbers with kinks or jumps, of dual numbers: its derivative where it has one, and at a
/// kink that of one of its sides.
template <class S, int N>
Dual<S, N> kinked(Operation operation, Dual<S, N> const& x, Dual<S, N> const& y) {
  Dual<S, N> out(kinked(operation, x.value, y.value));
  bool const of_two = operation == Operation::min || operation == Operation::max;
  if (of_two && (x.value < y.value) == (operation == Operation::min)) return x;
  if (of_two || (operation == Operation::where && x.value != S(0)) ||
      (operation == Operation::unless && x.value == S(0)))
    out.part = y.part;
  return out;
}

/// \f$\pi\f$.
template <class S>
S half_turn() {
  if constexpr (is_exact<S>) {
    detail::refuse_over_rationals(Operation::pi, 3.14159265358979324);
  } else {
    using std::atan2;
    using B = Base<S>;
    return S(B(atan2(B(0), B(-1))));
  }
}

/// A whole number beside a scalar.
template <Scalar S>
S whole_beside(S const&, int n) {
  return S(n);
}

/// The derivative of a function of one number at x, where its value is f.
/// @tparam T  a scalar, or a term of a tape
template <class T>
T slope(Operation operation, T const& x, T const& f) {
  switch (operation) {
    case Operation::sqrt:
      return 1 / (f + f);
    case Operation::cbrt:
      return 1 / (3 * (f * f));
    case Operation::exp:
      return f;
    case Operation::log:
      return 1 / x;
    case Operation::log2:
      return 1 / (elementary(Operation::log, whole_beside(x, 2)) * x);
    case Operation::log10:
      return 1 / (elementary(Operation::log, whole_beside(x, 10)) * x);
    case Operation::sin:
      return elementary(Operation::cos, x);
    case Operation::cos:
      return -elementary(Operation::sin, x);
    case Operation::tan:
      return 1 + f * f;
    case Operation::asin:
      return 1 / elementary(Operation::sqrt, T((1 - x) * (1 + x)));
    case Operation::acos:
      return -1 / elementary(Operation::sqrt, T((1 - x) * (1 + x)));
    case Operation::atan:
      return 1 / (1 + x * x);
    case Operation::sinh:
      return elementary(Operation::cosh, x);
    case Operation::cosh:
      return elementary(Operation::sinh, x);
    case Operation::tanh:
      return 1 - f * f;
    case Operation::asinh:
      return 1 / elementary(Operation::sqrt, T(1 + x * x));
    case Operation::acosh:
      return 1 / elementary(Operation::sqrt, T((x - 1) * (x + 1)));
    case Operation::atanh:
      return 1 / ((1 - x) * (1 + x));
    default:
      // Over double a kink has the derivative of one of its sides; a tape records none.
      if constexpr (std::same_as<T, double>) return operation == Operation::abs ? (x < 0 ? -1 : 1) : 0;
      detail::refuse_kinks(operation);
  }
}

template <class S, int N>
Dual<S, N> elementary(Operation operation, Dual<S, N> const& x) {
  S const f = elementary(operation, x.value);
  return chain(x, f, S(slope(operation, x.value, f)));
}

}  // namespace actio
