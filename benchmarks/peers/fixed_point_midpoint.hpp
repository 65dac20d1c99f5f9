// The implicit midpoint on the quantised sphere as the published codes find it: a fixed point with two
// complex products an iteration, begun with the increment of the last step, to the square root of the
// rounding.
#pragma once

#include "actio/quantized_sphere/laplacian.hpp"

extern "C" void zgemm_(char const* a_transposed, char const* b_transposed, int const* m, int const* n,
                       int const* k, void const* alpha, void const* a, int const* lda, void const* b,
                       int const* ldb, void const* beta, void* c, int const* ldc);

namespace peers {

/// out = a b of square matrices.
inline void complex_product(actio::sphere::ComplexMatrix<> const& a, actio::sphere::ComplexMatrix<> const& b,
                            actio::sphere::ComplexMatrix<>& out) {
  int const n = static_cast<int>(a.rows());
  std::complex<double> const one = 1, zero = 0;
  out.resize(n, n);
  zgemm_("N", "N", &n, &n, &n, &one, a.data(), &n, b.data(), &n, &zero, out.data(), &n);
}

/// The largest sum of moduli in a row.
inline double largest_row(actio::sphere::ComplexMatrix<> const& a) {
  return a.cwiseAbs().rowwise().sum().maxCoeff();
}

/// Steps of one length.
struct FixedPointMidpoint {
  actio::sphere::SphereLaplacian const& laplacian;
  double h;
  actio::sphere::ComplexMatrix<> increment = {};
  actio::sphere::ComplexMatrix<> p = {}, first = {}, second = {}, commutator = {};
  actio::sphere::SkewHermitian<> stream = {};
  double iterations = 0;  ///< of all steps together

  void step(actio::sphere::ComplexMatrix<>& w) {
    auto const n = w.rows();
    if (increment.rows() != n) increment.setZero(n, n);
    double const hbar = actio::sphere::QuantizedSphere(static_cast<int>(n)).hbar();
    double const tolerance = std::sqrt(std::numeric_limits<double>::epsilon()) * h / hbar * largest_row(w);
    for (int k = 0; k < 10; ++k, ++iterations) {
      second = w + increment;
      actio::sphere::SkewHermitian<> const middle(second.real(), second.imag());
      laplacian.solve(middle, stream);
      p.resize(n, n), p.real() = h / (2 * hbar) * stream.real, p.imag() = h / (2 * hbar) * stream.imaginary;
      complex_product(p, second, first);
      complex_product(first, p, second);
      commutator = first - first.adjoint();
      second += commutator;
      double const change = largest_row(second - increment);
      increment.swap(second);
      if (change < tolerance) break;
    }
    w += 2 * commutator;
  }
};

}  // namespace peers
