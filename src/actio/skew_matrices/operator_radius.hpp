// How large a skew-Hermitian matrix is, as an operator and beside another one, in O(N^2) operations.
#pragma once

#include <Eigen/Core>

#include <algorithm>
#include <cmath>

#include "actio/skew_matrices/dense_matrices.hpp"
#include "actio/skew_matrices/skew_hermitian.hpp"

namespace actio::sphere {

/// The largest modulus of an eigenvalue by the method of Lanczos: an estimate from below, good to one per
/// cent or so.
template <class Real>
double lanczos_radius(SkewHermitian<Real> const& a) {
  auto const n = a.size();
  constexpr int most = 16;
  using Vectors = Eigen::Matrix<double, Eigen::Dynamic, 2>;
  Vectors v(n, 2), before = Vectors::Zero(n, 2), u(n, 2);
  for (Eigen::Index k = 0; k < n; ++k) {
    auto const x = static_cast<double>(k);
    v.row(k) << std::cos(1.7 * x * x + x), std::sin(2.3 * x * x + 1);
  }
  v.normalize();
  Eigen::VectorXd diagonal(most), beside(most);
  int count = 0;
  while (count < most) {
    // u = -iA v.
    Vectors const r = a.real * v, j = a.imaginary * v;
    u.col(0) = j.col(0) + r.col(1), u.col(1) = j.col(1) - r.col(0);
    diagonal[count] = u.cwiseProduct(v).sum();
    u -= diagonal[count] * v;
    if (count > 0) u -= beside[count - 1] * before;
    beside[count] = u.norm();
    ++count;
    if (!(beside[count - 1] > 1e-12 * diagonal.head(count).cwiseAbs().maxCoeff())) break;
    before = v, v = u / beside[count - 1];
  }
  return tridiagonal_values<Eigen::MatrixXd>(diagonal.head(count), beside.head(count - 1))
      .cwiseAbs()
      .maxCoeff();
}

/// The largest modulus of an eigenvalue by power iteration on \f$-A^2\f$: an estimate from below, good to
/// some per cent.
template <class Real>
Real power_radius(SkewHermitian<Real> const& a) {
  using Vector = Eigen::Matrix<Real, Eigen::Dynamic, 1>;
  auto const n = a.size();
  Vector x(n), y(n);
  for (Eigen::Index k = 0; k < n; ++k)
    x[k] = std::cos(Real(1.7) * static_cast<Real>(k)), y[k] = std::sin(Real(2.3) * static_cast<Real>(k) + 1);
  Real radius = 0;
  for (int k = 0; k < 8; ++k) {
    Real const size = std::hypot(x.norm(), y.norm());
    if (!(size > 0)) return 0;
    x /= size, y /= size;
    Vector const u = a.real * x - a.imaginary * y;
    y = a.real * y + a.imaginary * x, x = u;
    radius = std::hypot(x.norm(), y.norm());
  }
  return radius;
}

/// The largest eigenvalue of a matrix that changes slowly: its ratio to the norm is estimated now and then.
struct FollowedRadius {
  double ratio = 0;  ///< of an estimate to the norm; zero where there is none
  int age = 0;       ///< steps since it was made

  /// A bound of the eigenvalues of the next matrix.
  template <class Real>
  double bound(SkewHermitian<Real> const& a) {
    constexpr int steps_of_estimate = 16;  // for which it is taken as good
    double const size = norm(a);
    if (ratio == 0 || age >= steps_of_estimate) ratio = size == 0 ? 1 : lanczos_radius(a) / size, age = 0;
    return std::max(1.05 * ratio * size, 1e-6);
  }
};

/// \f$|X-Y|/|Y|\f$ by what is on and below the diagonals, the diagonals counted as the rest; |X| where Y
/// vanishes.
template <class Real>
Real relative_distance(SkewHermitian<Real> const& x, SkewHermitian<Real> const& y) {
  Real apart = 0, size = 0;
  for (Eigen::Index c = 0; c < x.size(); ++c) {
    auto const below = x.size() - c;
    apart += (x.real.col(c).tail(below) - y.real.col(c).tail(below)).squaredNorm() +
             (x.imaginary.col(c).tail(below) - y.imaginary.col(c).tail(below)).squaredNorm();
    size += y.real.col(c).tail(below).squaredNorm() + y.imaginary.col(c).tail(below).squaredNorm();
  }
  return size == 0 ? std::sqrt(apart) : std::sqrt(apart / size);
}

}  // namespace actio::sphere
