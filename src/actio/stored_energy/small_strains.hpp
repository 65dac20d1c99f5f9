// Deformations by what they differ from none: the gradient of the displacement \f$H = F-1\f$, Green's strain
// \f$E = \tfrac12(C-1) = \tfrac12(H+H^T+H^TH)\f$, and functions of the volume that vanish with them.
//
// A body at rest has the same numbers in F and C whatever the strain below the last place. Here nothing
// subtracts one: accuracy some units in the last place, however small the strain.
#pragma once

#include <cmath>

#include "actio/linear_algebra/linear.hpp"

namespace actio::media {

/// \f$x-\log(1+x)\f$ for x > -1.
double without_logarithm(double x);

/// \f$e^x-1-x\f$.
double exponential_beyond_line(double x);

/// The sum of the principal minors with two rows, and the determinant; zero where a matrix has fewer.
template <int d>
std::array<double, 2> minors_of(Matrix<double, d, d> const& A) {
  if constexpr (d == 1) {
    return {0, 0};
  } else if constexpr (d == 2) {
    return {A(0, 0) * A(1, 1) - A(0, 1) * A(1, 0), 0};
  } else {
    double const a = A(1, 1) * A(2, 2) - A(1, 2) * A(2, 1), b = A(0, 0) * A(2, 2) - A(0, 2) * A(2, 0),
                 c = A(0, 0) * A(1, 1) - A(0, 1) * A(1, 0);
    return {a + b + c, A(0, 0) * a + A(1, 0) * (A(2, 1) * A(0, 2) - A(2, 2) * A(0, 1)) +
                           A(2, 0) * (A(0, 1) * A(1, 2) - A(0, 2) * A(1, 1))};
  }
}

/// \f$E = \tfrac12(H+H^T+H^TH)\f$.
template <int d>
Matrix<double, d, d> green_strain(Matrix<double, d, d> const& H) {
  Matrix<double, d, d> E;
  for (int i = 0; i < d; ++i)
    for (int j = 0; j <= i; ++j) {
      double sum = 0;
      for (int a = 0; a < d; ++a) sum += H(a, i) * H(a, j);
      E(i, j) = E(j, i) = 0.5 * ((H(i, j) + H(j, i)) + sum);
    }
  return E;
}
/// \f$1+A\f$.
template <int d>
Matrix<double, d, d> beyond_identity(Matrix<double, d, d> A) {
  for (int i = 0; i < d; ++i) A(i, i) += 1;
  return A;
}
/// \f$A-1\f$.
template <int d>
Matrix<double, d, d> without_identity(Matrix<double, d, d> A) {
  for (int i = 0; i < d; ++i) A(i, i) -= 1;
  return A;
}

/// What energies know of a strain besides its entries.
template <int d>
struct StrainMeasures {
  double logarithm;   ///< \f$\log J\f$
  double volume;      ///< \f$J-1\f$
  double distortion;  ///< \f$\Tr E-\log J\f$, which is of the second order
  double second;      ///< the sum of the principal minors of E

  /// Of Green's strain.
  explicit StrainMeasures(Matrix<double, d, d> const& E) {
    auto const [minors, third] = minors_of(E);
    double const square = 2 * (E.trace() + (2 * minors + 4 * third));  // J^2 - 1
    logarithm = 0.5 * std::log1p(square), volume = square / (1 + std::sqrt(1 + square));
    distortion = 0.5 * without_logarithm(square) - 2 * minors - 4 * third, second = minors;
  }
};

}  // namespace actio::media
