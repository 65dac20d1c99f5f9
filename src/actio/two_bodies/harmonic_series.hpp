// Polynomials in three variables modulo |s|^2, unrolled: what a mutual potential needs of the series of
// moments.
//
// The Laplacian of 1/r vanishes, so multiples of |s|^2 in a series have no gravity. With
// s_z^2 = -(s_x^2 + s_y^2) a homogeneous polynomial of degree n is P(s_x, s_y) + s_z Q(s_x, s_y): 2n + 1
// coefficients instead of (n + 1)(n + 2)/2. Rotations leave |s|^2 as it is, so that everything below is of
// classes. Loops are unrolled by the compiler's own lists, and the coefficients never see the memory.
#pragma once

#include <array>
#include <utility>

#include "actio/fast_body/space/half_turn.hpp"

namespace actio::bodies {
namespace detail {

/// f(0), ..., f(n - 1), with constants.
template <int n, class F>
[[gnu::always_inline]] constexpr void unrolled(F&& f) {
  [&]<int... I>(std::integer_sequence<int, I...>) __attribute__((always_inline)) {
    (f(std::integral_constant<int, I>{}), ...);
  }
  (std::make_integer_sequence<int, n>{});
}
/// \def ACTIO_UNROLLED
/// The body of a loop that is unrolled, as a callable of the constant k.
#define ACTIO_UNROLLED(k) [&](auto k) __attribute__((always_inline))

/// A homogeneous polynomial of degree n modulo \f$|s|^2\f$: `plain[j]` belongs to \f$s_x^{n-j}s_y^j\f$ and
/// `with_z[j]` to \f$s_x^{n-1-j}s_y^js_z\f$.
template <int n, class T>
struct Harmonic {
  std::array<T, n + 1> plain{};
  std::array<T, n> with_z{};
};
template <class T>
struct Harmonic<0, T> {
  std::array<T, 1> plain{};
  std::array<T, 1> with_z{};  // none
};

/// z += the product of two polynomials in two variables, by coefficients.
template <class T, std::size_t A, std::size_t B, std::size_t C>
[[gnu::always_inline]] inline void add_product_of_two(std::array<T, C>& z, std::array<T, A> const& p,
                                                      std::array<T, B> const& q) {
  unrolled<int(A)>(ACTIO_UNROLLED(i) { unrolled<int(B)>(ACTIO_UNROLLED(j) { z[i + j] += p[i] * q[j]; }); });
}

/// The product.
template <int n, int m, class T>
[[gnu::always_inline]] inline Harmonic<n + m, T> times(Harmonic<n, T> const& p, Harmonic<m, T> const& q) {
  Harmonic<n + m, T> r;
  add_product_of_two(r.plain, p.plain, q.plain);
  if constexpr (m > 0) add_product_of_two(r.with_z, p.plain, q.with_z);
  if constexpr (n > 0) add_product_of_two(r.with_z, p.with_z, q.plain);
  if constexpr (n > 0 && m > 0) {
    std::array<T, n + m - 1> square{};
    add_product_of_two(square, p.with_z, q.with_z);
    unrolled<n + m - 1>(ACTIO_UNROLLED(j) { r.plain[j] -= square[j], r.plain[j + 2] -= square[j]; });
  }
  return r;
}
/// p += c q.
template <int n, class T>
[[gnu::always_inline]] inline void add_multiple(Harmonic<n, T>& p, T const& c, Harmonic<n, T> const& q) {
  unrolled<n + 1>(ACTIO_UNROLLED(j) { p.plain[j] += c * q.plain[j]; });
  unrolled<n>(ACTIO_UNROLLED(j) { p.with_z[j] += c * q.with_z[j]; });
}

/// Derivatives of 1/r of one degree n: a linear form on polynomials modulo \f$|s|^2\f$, with as many entries.
template <int n, class T>
struct Derivatives : Harmonic<n, T> {
  /// That of \f$\partial_x^{n-2-j}\partial_y^j\partial_z^2\f$.
  [[gnu::always_inline]] T twice_z(int j) const { return -(this->plain[j] + this->plain[j + 2]); }
  /// The form on a polynomial.
  [[gnu::always_inline]] T on(Harmonic<n, T> const& p) const {
    T a = p.plain[0] * this->plain[0], b{};
    unrolled<n>(
        ACTIO_UNROLLED(j) { a += p.plain[j + 1] * this->plain[j + 1], b += p.with_z[j] * this->with_z[j]; });
    return a + b;
  }
};
/// sum += the form q -> D(p q) on polynomials of degree m.
template <int n, int m, class T>
[[gnu::always_inline]] inline void add_contraction(Derivatives<m, T>& sum, Harmonic<n, T> const& p,
                                                   Derivatives<n + m, T> const& D) {
  unrolled<n + 1>(ACTIO_UNROLLED(i) {
    unrolled<m + 1>(ACTIO_UNROLLED(j) { sum.plain[j] += p.plain[i] * D.plain[i + j]; });
    unrolled<m>(ACTIO_UNROLLED(j) { sum.with_z[j] += p.plain[i] * D.with_z[i + j]; });
  });
  unrolled<n>(ACTIO_UNROLLED(i) {
    unrolled<m + 1>(ACTIO_UNROLLED(j) { sum.plain[j] += p.with_z[i] * D.with_z[i + j]; });
    unrolled<m>(ACTIO_UNROLLED(j) { sum.with_z[j] += p.with_z[i] * D.twice_z(i + j); });
  });
}
/// The values of D on \f$s_xp, s_yp, s_zp\f$.
template <int n, class T>
[[gnu::always_inline]] inline Three<T> gradient_on(Harmonic<n, T> const& p, Derivatives<n + 1, T> const& D) {
  Three<T> g{};
  unrolled<n + 1>(ACTIO_UNROLLED(j) {
    g[0] += p.plain[j] * D.plain[j], g[1] += p.plain[j] * D.plain[j + 1], g[2] += p.plain[j] * D.with_z[j];
  });
  unrolled<n>(ACTIO_UNROLLED(j) {
    g[0] += p.with_z[j] * D.with_z[j], g[1] += p.with_z[j] * D.with_z[j + 1],
        g[2] += p.with_z[j] * D.twice_z(j);
  });
  return g;
}

/// \f$s\times\nabla p\f$, component by component.
template <int n, class T>
[[gnu::always_inline]] inline std::array<Harmonic<n, T>, 3> rotation_rates(Harmonic<n, T> const& p) {
  std::array<Harmonic<n, T>, 3> L;
  auto &x = L[0], &y = L[1], &z = L[2];
  unrolled<n + 1>(ACTIO_UNROLLED(j) {
    if constexpr (j < n) z.plain[j] += double(j + 1) * p.plain[j + 1];
    if constexpr (j > 0) z.plain[j] -= double(n - j + 1) * p.plain[j - 1];
  });
  unrolled<n>(ACTIO_UNROLLED(j) {
    if constexpr (j + 1 < n) z.with_z[j] += double(j + 1) * p.with_z[j + 1];
    if constexpr (j > 0) z.with_z[j] -= double(n - j) * p.with_z[j - 1];
    // y d/dz - z d/dy and z d/dx - x d/dz, with -z^2 = x^2 + y^2.
    x.with_z[j] -= double(j + 1) * p.plain[j + 1];
    y.with_z[j] += double(n - j) * p.plain[j];
    x.plain[j + 1] += p.with_z[j];
    y.plain[j] -= p.with_z[j];
    if constexpr (j > 0) {
      x.plain[j - 1] += double(j) * p.with_z[j];
      x.plain[j + 1] += double(j) * p.with_z[j];
    }
    if constexpr (j + 1 < n) {
      y.plain[j] -= double(n - 1 - j) * p.with_z[j];
      y.plain[j + 2] -= double(n - 1 - j) * p.with_z[j];
    }
  });
  return L;
}

/// \f$\partial^k(1/r)\f$ at a unit vector for \f$|k|\f$ up to N, by
/// \f$f^{(m)}_{k+e_i}=k_if^{(m+1)}_{k-e_i}+x_if^{(m+1)}_k\f$ from \f$f^{(m)}_0=(-1)^m(2m-1)!!\f$.
template <int N, class T>
struct InverseDistance {
  /// `table[m][place(i, j)]` is \f$f^{(m)}_{(i,j,0)}\f$.
  static constexpr int place(int i, int j) { return (i + j) * (i + j + 1) / 2 + j; }
  std::array<std::array<T, place(0, N + 1)>, N + 1> table;
  T z;

  [[gnu::always_inline]] explicit InverseDistance(Three<T> const& x) : z(x[2]) {
    unrolled<N + 1>(ACTIO_UNROLLED(m) { table[m][0] = T{} + start(m); });
    unrolled<N>(ACTIO_UNROLLED(less) {
      constexpr int n = less + 1;  // degrees one after the other
      unrolled<N + 1 - n>(ACTIO_UNROLLED(m) {
        unrolled<n + 1>(ACTIO_UNROLLED(j) {
          constexpr int i = n - j;
          auto const& up = table[m + 1];
          if constexpr (i > 0) {
            T value = x[0] * up[place(i - 1, j)];
            if constexpr (i > 1) value += double(i - 1) * up[place(i - 2, j)];
            table[m][place(i, j)] = value;
          } else {
            T value = x[1] * up[place(0, j - 1)];
            if constexpr (j > 1) value += double(j - 1) * up[place(0, j - 2)];
            table[m][place(0, j)] = value;
          }
        });
      });
    });
  }
  /// Those of one degree.
  template <int n>
  [[gnu::always_inline]] Derivatives<n, T> of() const {
    Derivatives<n, T> D;
    unrolled<n + 1>(ACTIO_UNROLLED(j) { D.plain[j] = table[0][place(n - j, j)]; });
    unrolled<n>(ACTIO_UNROLLED(j) { D.with_z[j] = z * table[1][place(n - 1 - j, j)]; });
    return D;
  }

 private:
  static constexpr double start(int m) {
    double value = 1;
    for (int k = 1; k <= m; ++k) value *= -(2 * k - 1);
    return value;
  }
};

}  // namespace detail
}  // namespace actio::bodies
