// The exact motion of a free body over a short step, by a power series without a branch.
//
// Axis 2 is the one with the middle moment; J = 1/I, and 2H = J1 M1^2 + J2 M2^2 + J3 M3^2 twice the energy.
// Start the clock where M2 = 0; then M2 is an odd function m(t), and
//
//     delta_i = (m/m') (J_i (L^2 - m^2) - (2H - J2 m^2)) / L, T = L J2 t + L (2H - J2 L^2) int_0^t
//     ds/(L^2 - m(s)^2), t = h/2,
//
// make the half turn of half_turn.hpp the exact motion over h, from every point of the orbit. With m^2 = a b
// z, a = J1 L^2 - 2H, b = 2H - J3 L^2,
//
//     z'' = 2 - 4 s1 z + 6 s2 z^2, s1 = (J1 - J2) b + (J2 - J3) a, s2 = (J1 - J2) (J2 - J3) a b,
//     z = t^2 - ...
//
// Everything is a sum of terms of one sign: nothing is lost for bodies that are nearly symmetric, spherical,
// long, flat, or turn about the middle axis.
#pragma once

#include <algorithm>
#include <concepts>

#include "actio/fast_body/space/half_turn.hpp"
#include "actio/numbers/pack.hpp"

namespace actio::bodies {

/// Differences of inverse moments, without the cancellation: \f$J_i-J_j = (I_j-I_i)/(I_iI_j)\f$. Axis 2,
/// index 1, must have the middle moment.
template <class T>
struct InverseMoments {
  Three<T> J;  ///< \f$1/I_i\f$
  T d12;       ///< \f$J_1-J_2\f$
  T d23;       ///< \f$J_2-J_3\f$, of the same sign
  T d13;       ///< \f$J_1-J_3\f$, their sum

  InverseMoments() = default;
  /// @param I  moments of inertia, in any unit
  explicit InverseMoments(Three<T> const& I)
      : J{1 / I[0], 1 / I[1], 1 / I[2]},
        d12((I[1] - I[0]) * J[0] * J[1]),
        d23((I[2] - I[1]) * J[1] * J[2]),
        d13(d12 + d23) {}
};

/// An orbit of the momentum: the constants that the exact flow over a short time depends on. The momentum has
/// the length 1; one of length L runs through the same orbit L times as fast.
template <class T>
struct Orbit {
  T a;       ///< \f$J_1-2H\f$
  T b;       ///< \f$2H-J_3\f$, of the same sign
  T beside;  ///< \f$2H-J_2\f$; zero on the separatrix
  /// \f$(J_1-J_2)b+(J_2-J_3)a \ge 0\f$; between once and twice the square of the frequency of Jacobi's
  /// functions
  T s1;
  T s2;  ///< \f$(J_1-J_2)(J_2-J_3)ab\f$

  /// @param u  direction of the body momentum
  [[gnu::always_inline]] Orbit(InverseMoments<T> const& body, Three<T> const& u) {
    T const x = u[0] * u[0], y = u[1] * u[1], z = u[2] * u[2];
    a = body.d12 * y + body.d13 * z;
    b = body.d13 * x + body.d23 * y;
    beside = body.d12 * x - body.d23 * z;
    s1 = body.d12 * b + body.d23 * a;
    s2 = body.d12 * body.d23 * (a * b);
  }
};

namespace detail {
template <int terms, class T = double>
struct ShortTable;
}

/// The three functions of the exact flow over a short time, each divided by the first term of its series:
/// power series in \f$X = s_1t^2\f$, \f$Y = s_2t^4\f$ and \f$W = abt^2\f$.
///
/// Cut after `terms` terms in \f$t^2\f$; the first that is left out is of the relative size
/// \f$(0.41\,X)^{terms}\f$ or less.
template <class T>
struct ShortSeries {
  T lever;   ///< \f$m/(m't) = 1 + X/3 + \dots\f$
  T square;  ///< \f$m^2/W = 1 - X/3 + \dots\f$
  T mean;    ///< \f$\frac1t\int_0^tds/(1-m^2) = 1 + W/3 + \dots\f$

  /// Coefficient after coefficient, for every kind of number.
  template <int terms>
  static ShortSeries by_recursion(T const& X, T const& Y, T const& W) {
    std::array<T, terms> z, inverse;
    z[0] = inverse[0] = T{} + 1;
    T square = z[0], slope = z[0], mean = z[0];
    for (int n = 1; n < terms; ++n) {
      T product = T{}, sum = T{};
      for (int i = 0; i + 1 < n; ++i) product += z[i] * z[n - 2 - i];
      for (int i = 0; i < n; ++i) sum += z[i] * inverse[n - 1 - i];
      z[n] = (6 * Y * product - 4 * X * z[n - 1]) / double((2 * n + 2) * (2 * n + 1));
      inverse[n] = W * sum;
      square += z[n], slope += z[n] * double(n + 1), mean += inverse[n] / double(2 * n + 1);
    }
    return {square / slope, square, mean};
  }

  /// The same polynomials with coefficients from a table, for doubles: short chains of operations, and no
  /// division.
  template <int terms>
  [[gnu::always_inline]] static ShortSeries by_table(detail::ShortTable<terms, Base<T>> const& table,
                                                     T const& X, T const& Y, T const& W)
    requires OfDoubles<T>;
};

namespace detail {

/// Coefficients of the polynomials of \ref ShortSeries: of \f$Y^jX^i\f$, and of \f$W^kY^jX^i\f$, with
/// \f$k+2j+i\f$ less than `terms`. Worked out when the program starts to use it.
template <int terms, class T>
struct ShortTable {
  static constexpr int rows = (terms + 1) / 2;
  using Plane = std::array<std::array<T, terms>, rows>;
  Plane lever, square;
  std::array<Plane, terms> mean;

  ShortTable()
    requires is_pack<T>
  {
    set_all_lanes(*this, ShortTable<terms>());
  }
  ShortTable()
    requires std::same_as<T, double>
  {
    using Row = std::array<long double, rows>;
    std::array<Row, terms> z{}, ratio{};
    std::array<std::array<Row, terms>, terms> inverse{};
    z[0][0] = ratio[0][0] = inverse[0][0][0] = 1;
    for (int n = 1; n < terms; ++n) {
      for (int j = 0; j < rows; ++j) {
        z[n][j] = -4 * z[n - 1][j] / ((2 * n + 2) * (2 * n + 1));
        for (int i = 0; i + 1 < n; ++i)
          for (int k = 0; k < j; ++k)
            z[n][j] += 6 * z[i][k] * z[n - 2 - i][j - 1 - k] / ((2 * n + 2) * (2 * n + 1));
      }
      // (sum (n+1) z_n) ratio = sum z_n, and (1 - W t^2 sum z_n) inverse = 1
      for (int j = 0; j < rows; ++j) {
        ratio[n][j] = z[n][j];
        for (int m = 1; m <= n; ++m)
          for (int k = 0; k <= j; ++k) ratio[n][j] -= (m + 1) * z[m][k] * ratio[n - m][j - k];
        for (int w = 1; w <= n; ++w)
          for (int i = 0; i < n; ++i)
            for (int k = 0; k <= j; ++k) inverse[n][w][j] += z[i][k] * inverse[n - 1 - i][w - 1][j - k];
      }
    }
    for (int n = 0; n < terms; ++n)
      for (int j = 0; 2 * j <= n; ++j) {
        lever[j][n - 2 * j] = static_cast<double>(ratio[n][j]);
        square[j][n - 2 * j] = static_cast<double>(z[n][j]);
        for (int w = 0; w + 2 * j <= n; ++w)
          mean[w][j][n - 2 * j - w] = static_cast<double>(inverse[n][w][j] / (2 * n + 1));
      }
  }
};
template <int terms, class T = double>
ShortTable<terms, T> const& short_table() {
  static ShortTable<terms, T> const table;
  return table;
}

/// x, x^2, x^4, x^8: enough for sixteen terms.
template <class T>
struct Powers {
  T one, two, four, eight;
  [[gnu::always_inline]] explicit Powers(T const& x)
      : one(x), two(x * x), four(two * two), eight(four * four) {}
};
/// \f$\sum_{n<count} c_n x^n\f$, halved again and again, so that the chain of operations grows with the
/// logarithm of their number.
template <int count, class T>
[[gnu::always_inline]] inline T power_sum(Base<T> const* c, Powers<T> const& x) {
  if constexpr (count == 1)
    return T(c[0]);
  else if constexpr (count == 2)
    return x.one * c[1] + c[0];
  else if constexpr (count <= 4)
    return x.two * power_sum<count - 2>(c + 2, x) + power_sum<2>(c, x);
  else if constexpr (count <= 8)
    return x.four * power_sum<count - 4>(c + 4, x) + power_sum<4>(c, x);
  else
    return x.eight * power_sum<count - 8>(c + 8, x) + power_sum<8>(c, x);
}
/// \f$\sum_j Y^j\sum_{i<count-2j} c_{ji}X^i\f$.
template <int count, int j = 0, class Plane, class T>
[[gnu::always_inline]] inline T plane_sum(Plane const& c, Powers<T> const& X, T const& Y) {
  if constexpr (count <= 2)
    return power_sum<count>(c[j].data(), X);
  else
    return Y * plane_sum<count - 2, j + 1>(c, X, Y) + power_sum<count>(c[j].data(), X);
}
/// \f$\sum_k W^k\sum_jY^j\sum_{i<count-k-2j} c_{kji}X^i\f$.
template <int count, int k = 0, class Planes, class T>
[[gnu::always_inline]] inline T space_sum(Planes const& c, Powers<T> const& X, T const& Y, T const& W) {
  if constexpr (count == 1)
    return plane_sum<1>(c[k], X, Y);
  else
    return W * space_sum<count - 1, k + 1>(c, X, Y, W) + plane_sum<count>(c[k], X, Y);
}

}  // namespace detail

/// The same polynomials with coefficients from a table.
template <class T>
template <int terms>
[[gnu::always_inline]] inline ShortSeries<T> ShortSeries<T>::by_table(
    detail::ShortTable<terms, Base<T>> const& table, T const& X, T const& Y, T const& W)
  requires OfDoubles<T>
{
  detail::Powers<T> const powers(X);
  // Of the mean the terms without W are 1 alone.
  return {detail::plane_sum<terms>(table.lever, powers, Y), detail::plane_sum<terms>(table.square, powers, Y),
          W * detail::space_sum<terms - 1, 1>(table.mean, powers, Y, W) + 1};
}

/// What the series give at one time: all that the exact step needs besides sines.
template <class T>
struct ShortFlow {
  T lever;   ///< \f$m/m'\f$
  T square;  ///< \f$m^2\f$
  T twist;   ///< T

  /// @param t  half the step, times the magnitude of the momentum; \f$s_1t^2\f$ small against 1: see
  ///           \ref ShortSeries for what `terms` leave out
  template <int terms>
  [[gnu::always_inline]] static ShortFlow at(InverseMoments<T> const& body, Orbit<T> const& orbit,
                                             T const& t) {
    T const x = t * t, X = orbit.s1 * x, Y = orbit.s2 * (x * x), W = orbit.a * orbit.b * x;
    ShortSeries<T> s;
    if constexpr (OfDoubles<T> && terms <= 12)
      s = ShortSeries<T>::template by_table<terms>(detail::short_table<terms, Base<T>>(), X, Y, W);
    else
      s = ShortSeries<T>::template by_recursion<terms>(X, Y, W);
    return {t * s.lever, W * s.square, t * (body.J[1] + orbit.beside * s.mean)};
  }
};

}  // namespace actio::bodies
