// The principal logarithm of a matrix: square roots until it is near the identity, then a series.
#pragma once

#include "actio/linear_algebra/iex.hpp"

namespace actio {

/// The square root with eigenvalues in the right half plane, by the product form of the Denman-Beavers
/// iteration.
/// @throws OutsideDomain  where it does not converge: an eigenvalue on the negative real axis, or too near to
///                        it
template <MatrixLike M>
typename M::PlainObject matrix_square_root(M const& a) {
  using S = typename M::Scalar;
  using Matrix = typename M::PlainObject;
  Matrix const one = Matrix::Identity(a.rows(), a.cols());
  Matrix x = a, m = a;
  double distance = row_norm(Matrix(m - one));
  for (int iteration = 0; iteration < 60; ++iteration) {
    Matrix inverse;
    try {
      inverse = inverse_matrix(m, "matrix_square_root");
    } catch (Singular const& singular) {
      throw OutsideDomain("log", "no eigenvalue may lie on the negative real axis (3.19)", singular.measured,
                          singular.bound);
    }
    x = (x + x * inverse) / S(2);
    m = (one + (m + inverse) / S(2)) / S(2);
    double const next = row_norm(Matrix(m - one));
    // Quadratic convergence: once the distance no longer falls it is rounding.
    if (next < 1e-6 && (next == 0 || next > 0.25 * distance)) return x;
    distance = next;
  }
  throw OutsideDomain(
      "log", "no eigenvalue may lie on the negative real axis (3.19); distance left after 60 iterations",
      distance, 1e-6);
}

/// The logarithm with eigenvalues of imaginary part inside (-pi, pi), for plain scalars.
///
/// \snippet numbers.cpp matrix_exponential
///
/// Accuracy: a few epsilon relative to the largest entry, as long as no eigenvalue comes near the negative
/// real axis; near it the answer is compared with its exponential, and refused where they differ.
/// @throws OutsideDomain   at and next to the edge of the chart
/// @throws NotInThisField  over an exact arithmetic, where a - 1 is not nilpotent
template <class M>
  requires Real<typename M::Scalar>
typename M::PlainObject matrix_logarithm(M const& a) {
  using S = typename M::Scalar;
  using Matrix = typename M::PlainObject;
  if (exact_arithmetic<S>()) return nilpotent_logarithm(a);
  Matrix const one = Matrix::Identity(a.rows(), a.cols());
  if (!std::isfinite(row_norm(a))) throw NotFinite("log");
  Matrix root = a;
  int roots = 0;
  for (; row_norm(Matrix(root - one)) > 0.25; ++roots) {
    if (roots == 100)
      throw OutsideDomain("log", "the square roots of an invertible matrix tend to 1",
                          row_norm(Matrix(root - one)), 0.25);
    root = matrix_square_root(root);
  }

  // log(1 + e) = 2 artanh(z) with z = e / (2 + e), whose terms fall like 7^-2k.
  Matrix const e = root - one;
  Matrix const z = solve_linear(Matrix(e + S(2) * one), e, "log");
  Matrix const square = z * z;
  Matrix sum = Matrix::Zero(a.rows(), a.cols());
  for (int k = geometric_terms<S>(1.0 / 49); k >= 0; --k) sum = one / S(2 * k + 1) + square * sum;
  Matrix result = z * sum * S(2);
  for (int i = 0; i < roots; ++i) result *= S(2);

  // A logarithm that does not give the matrix back is no logarithm. Square roots near the edge lose half the
  // digits.
  Matrix const back = matrix_exponential(result);
  double const miss = row_norm(Matrix(back - a)) / row_norm(a);
  using std::sqrt;
  double const bound = std::sqrt(to_double(epsilon<S>())) * 1e-3;
  if (!(miss <= bound))
    throw OutsideDomain("log",
                        "no eigenvalue may come near the negative real axis (3.19); exp(log g) misses g by",
                        miss, bound);
  return result;
}

}  // namespace actio
