// Determinants of real and complex matrices over any field, by elimination with row exchanges.
#pragma once

#include <utility>
#include <vector>

#include "actio/numbers/dual.hpp"

namespace actio {

/// x + i y over any field, a dual number or a fraction included.
template <Scalar S>
struct Complex {
  S re;  ///< the real part
  S im;  ///< the imaginary part

  /// x + i y.
  explicit Complex(S const& x, S const& y = S(0)) : re(x), im(y) {}
  /// x - i y.
  Complex conjugate() const { return Complex(re, -im); }
  /// \f$x^2+y^2\f$.
  S square_of_modulus() const { return re * re + im * im; }

  friend Complex operator-(Complex const& a) { return Complex(-a.re, -a.im); }
  friend Complex operator-(Complex const& a, Complex const& b) { return Complex(a.re - b.re, a.im - b.im); }
  friend Complex operator*(Complex const& a, Complex const& b) {
    return Complex(a.re * b.re - a.im * b.im, a.re * b.im + a.im * b.re);
  }
  friend Complex operator/(Complex const& a, Complex const& b) {
    S const inverse = S(1) / b.square_of_modulus();
    Complex const c = a * b.conjugate();
    return Complex(c.re * inverse, c.im * inverse);
  }
};

namespace detail {

template <class S>
Base<S> size_of_pivot(S const& x) { return magnitude(base_value(x)); }
template <class S>
Base<S> size_of_pivot(Complex<S> const& z) {
  return magnitude(base_value(z.re)) + magnitude(base_value(z.im));
}

/// The determinant of the n by n entries a, row by row.
template <class K>
K eliminated(std::vector<K> a, int n) {
  K product(1);
  for (int k = 0; k < n; ++k) {
    int pivot = k;
    for (int i = k + 1; i < n; ++i)
      if (size_of_pivot(a[i * n + k]) > size_of_pivot(a[pivot * n + k])) pivot = i;
    if (pivot != k) {
      for (int j = k; j < n; ++j) std::swap(a[k * n + j], a[pivot * n + j]);
      product = -product;
    }
    product = product * a[k * n + k];
    if (size_of_pivot(a[k * n + k]) == 0) return product;
    for (int i = k + 1; i < n; ++i) {
      K const factor = a[i * n + k] / a[k * n + k];
      for (int j = k + 1; j < n; ++j) a[i * n + j] = a[i * n + j] - factor * a[k * n + j];
    }
  }
  return product;
}

}  // namespace detail

/// The determinant of a square matrix. Its derivative is right where the matrix has an inverse.
template <MatrixLike M>
typename M::Scalar determinant_by_elimination(M const& a) {
  int const n = static_cast<int>(a.rows());
  std::vector<typename M::Scalar> entries;
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j) entries.push_back(a(i, j));
  return detail::eliminated(std::move(entries), n);
}

/// The determinant of the complex matrix A + i B, given by the first half of the columns of its real form
/// ((A, -B), (B, A)).
template <MatrixLike M>
Complex<typename M::Scalar> complex_determinant(M const& a) {
  int const n = static_cast<int>(a.rows()) / 2;
  std::vector<Complex<typename M::Scalar>> entries;
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j) entries.emplace_back(a(i, j), a(n + i, j));
  return detail::eliminated(std::move(entries), n);
}

}  // namespace actio
