// Functions of the squared angle that exp and log of rotations are made of.
//
// The angle itself, a square root, has no derivative at the identity. Everything here is a function of its
// square and is smooth through zero, so that dual numbers at the identity come out right.
#pragma once

#include <vector>

#include "actio/numbers/dual.hpp"

namespace actio {

/// One hundredth of the unit round-off of the scalar, as a double that a compiler can compute with.
template <class S>
constexpr double negligible() {
  double tiny = 0.01;
  for (int d = 0; d < decimal_digits<S>(); ++d) tiny *= 0.1;
  return tiny;
}

/// Number of terms of a series whose n-th term stays below `bound^n` that are not negligible.
template <class S>
constexpr int geometric_terms(double bound) {
  int n = 1;
  for (double term = bound; term > negligible<S>(); term *= bound) ++n;
  return n;
}

/// Number of terms of a series whose n-th term stays below \f$x^n/(2n)!\f$ that are not negligible.
template <class S>
constexpr int factorial_terms(double x = 1) {
  int n = 1;
  for (double term = x / 2; term > negligible<S>(); ++n) term *= x / ((2.0 * n + 2.0) * (2.0 * n + 1.0));
  return n;
}

/// Number of terms of a series whose n-th term stays below `bound^n / n!` that are not negligible.
template <class S>
constexpr int exponential_terms(double bound) {
  int n = 1;
  for (double term = bound; term > negligible<S>(); term *= bound / n) ++n;
  return n;
}

namespace detail {
/// A number that the compiler works out, but where the arithmetic is chosen when the program runs.
template <class S, auto count>
int counted() {
  if constexpr (ChosenAtRunTime<Base<S>>) {
    return count();
  } else {
    constexpr int n = count();
    return n;
  }
}
/// A table of numbers that is made when it is first needed, and again where the arithmetic was changed since;
/// one for each `Make`.
template <Plain S, class Make>
S const* table_of_arithmetic(int terms, Make const& make) {
  if constexpr (ChosenAtRunTime<S>) {
    static std::vector<S> table;
    static auto spell = S::spell() - 1;
    if (spell != S::spell()) table = make(terms), spell = S::spell();
    return table.data();
  } else {
    static std::vector<S> const table = make(terms);
    return table.data();
  }
}
/// The sum of a power series by Horner's rule. Steps of an integrator turn little: for |x| < 1/64 the first
/// `few` terms will do.
template <class S, class Make>
S sum_of_series(S const& x, int few, int all, Make const& make) {
  Base<S> const* const coefficients = table_of_arithmetic<Base<S>>(all, make);
  int n = (magnitude(base_value(x)) < ratio<Base<S>>(1, 64) ? few : all) - 1;
  S sum(coefficients[n]);
  while (--n >= 0) sum = sum * x + coefficients[n];
  return sum;
}
}  // namespace detail

constexpr long factorial(int n) { return n < 2 ? 1 : n * factorial(n - 1); }

/// The Stumpff function \f$c_k(x) = \sum_n (-x)^n/(2n+k)!\f$: \f$c_0 = \cos\sqrt x\f$,
/// \f$c_1 = \sin\sqrt x/\sqrt x\f$, and so on.
///
/// With \f$x = \theta^2\f$: \f$\exp\hat\omega = 1 + c_1\hat\omega + c_2\hat\omega^2\f$, and its differential
/// uses \f$c_2, c_3\f$. Their derivatives stay in the family, \f$c_k' = \tfrac12(k\,c_{k+2} - c_{k+1})\f$, so
/// no division by x is ever needed.
/// @param x  square of an angle; greater than -1
/// Accuracy: a few epsilon relative to \f$1/k!\f$.
template <int K, Real S>
S stumpff(S const& x) {
  if (base_value(x) < Base<S>(1)) {
    return detail::sum_of_series(x, detail::counted<S, [] { return factorial_terms<S>(1.0 / 64) + 1; }>(),
                                 detail::counted<S, [] { return factorial_terms<S>() + 1; }>(),
                                 [](int terms) {
                                   std::vector<Base<S>> c(terms);
                                   c[0] = Base<S>(1) / Base<S>(factorial(K));
                                   for (int n = 1; n < terms; ++n)
                                     c[n] = -c[n - 1] / Base<S>((2 * n + K) * (2 * n + K - 1));
                                   return c;
                                 });
  }
  using std::cos, std::sin, std::sqrt;
  if constexpr (K == 0) {
    return cos(S(sqrt(x)));
  } else if constexpr (K == 1) {
    S const angle = sqrt(x);
    return sin(angle) / angle;
  } else {
    // c_{k-2} = 1/(k-2)! - x c_k; for x >= 1 less than two digits cancel in the difference.
    return (S(1) / Base<S>(factorial(K - 2)) - stumpff<K - 2>(x)) / x;
  }
}
template <int K, class S, int N>
  requires Real<S>
Dual<S, N> stumpff(Dual<S, N> const& x) {
  S const slope = (stumpff<K + 2>(x.value) * Base<S>(K) - stumpff<K + 1>(x.value)) / Base<S>(2);
  return chain(x, S(stumpff<K>(x.value)), slope);
}

/// The k-th derivative of \f$a(x) = \arcsin\sqrt x/\sqrt x\f$ for \f$|x| \le 1/4\f$, by its
/// series; \f$a(-x) = \mathrm{arsinh}\sqrt x/\sqrt x\f$.
///
/// \f$2a(s^2)\f$ is the factor between the vector part s of a unit quaternion and its rotation vector.
template <int K, Real S>
S asinc_derivative(S const& x) {
  // a(x) = sum b_n x^n with b_0 = 1, b_n = b_{n-1} (2n-1)^2 / (2n (2n+1)); its terms fall like x^n.
  return detail::sum_of_series(x, detail::counted<S, [] { return geometric_terms<S>(1.0 / 64) + K + 1; }>(),
                               detail::counted<S, [] { return geometric_terms<S>(0.25) + 3 * K + 1; }>(),
                               [](int terms) {
                                 std::vector<Base<S>> c(terms);
                                 Base<S> b(1);
                                 for (int n = 0; n < terms + K; ++n) {
                                   if (n > 0)
                                     b *= Base<S>((2 * n - 1) * (2 * n - 1)) / Base<S>(2 * n * (2 * n + 1));
                                   if (n < K) continue;
                                   c[n - K] = b;
                                   for (int i = 0; i < K; ++i) c[n - K] *= Base<S>(n - i);
                                 }
                                 return c;
                               });
}
template <int K, class S, int N>
  requires Real<S>
Dual<S, N> asinc_derivative(Dual<S, N> const& x) {
  return chain(x, S(asinc_derivative<K>(x.value)), S(asinc_derivative<K + 1>(x.value)));
}

/// The k-th derivative of \f$b(x) = \frac1x\bigl(1 - \tfrac{\sqrt x}2\cot\tfrac{\sqrt x}2\bigr)\f$ for
/// \f$|x| < 1\f$, by its series.
///
/// \f$b = (c_3 - 2c_4)/(2c_2)\f$ with Stumpff's functions, and
/// \f$\mathrm{iex}(\hat\omega)^{-1} = 1 - \tfrac12\hat\omega + b(|\omega|^2)\,\hat\omega^2\f$ in 3-space.
template <int K, Real S>
S half_cotangent_derivative(S const& x) {
  // Its terms fall like (x/4 pi^2)^n. The coefficients are those of the quotient of two series.
  return detail::sum_of_series(
      x, detail::counted<S, [] { return geometric_terms<S>(1.0 / 39 / 64) + K + 1; }>(),
      detail::counted<S, [] { return geometric_terms<S>(1.0 / 39) + 2 * K + 2; }>(), [](int terms) {
        std::vector<Base<S>> below(terms + K), b(terms + K), c(terms);
        Base<S> power(1);  // (-1)^n/(2n)!
        for (int n = 0; n < terms + K; ++n) {
          Base<S> const two = power / Base<S>((2 * n + 1) * (2 * n + 2));
          Base<S> const three = two / Base<S>(2 * n + 3), four = three / Base<S>(2 * n + 4);
          below[n] = two * Base<S>(2);
          b[n] = three - four * Base<S>(2);
          for (int m = 1; m <= n; ++m) b[n] -= below[m] * b[n - m];
          power = -two;
        }
        for (int n = 0; n < terms; ++n) {
          c[n] = b[n + K];
          for (int i = 0; i < K; ++i) c[n] *= Base<S>(n + K - i);
        }
        return c;
      });
}
/// The same of a dual number.
template <int K, class S, int N>
  requires Real<S>
Dual<S, N> half_cotangent_derivative(Dual<S, N> const& x) {
  return chain(x, S(half_cotangent_derivative<K>(x.value)), S(half_cotangent_derivative<K + 1>(x.value)));
}
/// \f$b(x) = \frac1x\bigl(1 - \tfrac{\sqrt x}2\cot\tfrac{\sqrt x}2\bigr)\f$ for \f$-1 < x < 4\pi^2\f$.
template <Real S>
S half_cotangent(S const& x) {
  if (base_value(x) < Base<S>(1)) return half_cotangent_derivative<0>(x);
  return (stumpff<3>(x) - stumpff<4>(x) * Base<S>(2)) / (stumpff<2>(x) * Base<S>(2));
}

}  // namespace actio
