#include <Eigen/Core>

#include "actio/quantized_sphere/matrix_harmonics.hpp"

namespace actio::sphere {

DiagonalBasis::DiagonalBasis(int n, int m) : n_(n), m_(m), a_(n - m + 1) {
  for (int l = m; l <= n; ++l) {
    double const ll = l, nn = n, mm = m;
    a_[l - m] =
        l == m || l == n
            ? 0
            : 0.5 * std::sqrt((ll - mm) * (ll + mm) * (nn - ll) * (nn + ll) / ((2 * ll - 1) * (2 * ll + 1)));
  }
  join_ = std::clamp(static_cast<int>(std::lround(std::sqrt(static_cast<double>(m) * n))) - m, 0,
                     std::max(0, n - m - 2));
}

void DiagonalBasis::block(int first, Block& u) const {
  int const size = this->size();
  u.resize(size, lanes);
  Lanes x;
  for (int i = 0; i < lanes; ++i) x[i] = 0.5 * (size - 1) - std::min(first + i, size - 1);
  if (size == 1) {
    u.setConstant(sign());
    return;
  }
  // Up to the row behind the joint, whose two values are kept while those from the other end are found.
  forwards(x, u);
  Lanes const before = u.row(join_), behind = u.row(join_ + 1);
  backwards(x, u);
  Lanes const up = before.abs().max(behind.abs()).inverse(),
              down = u.row(join_).array().abs().max(u.row(join_ + 1).array().abs()).inverse();
  Lanes const q0 = u.row(join_).array() * down, q1 = u.row(join_ + 1).array() * down;
  Lanes const p0 = before * up, p1 = behind * up;
  Lanes const same = (p0 * q0 + p1 * q1) / (q0 * q0 + q1 * q1) * down;
  u.row(join_) = before;
  Lanes norm = Lanes::Zero();
  for (int r = 0; r < size; ++r) {
    u.row(r).array() *= r <= join_ ? up : same;
    norm += u.row(r).array().square();
  }
  norm = sign() * norm.rsqrt();
  for (int r = 0; r < size; ++r) u.row(r).array() *= norm;
}

void DiagonalBasis::forwards(Lanes const& x, Block& u) const {
  u.row(0).setConstant(smallest);
  for (int r = 0; r <= join_; ++r) {
    Lanes next = x * u.row(r).array();
    if (r > 0) next -= a_[r] * u.row(r - 1).array();
    u.row(r + 1) = next / a_[r + 1];
    if (r % 8 == 7 && u.row(r + 1).array().abs().maxCoeff() > largest) shrink(u, 0, r + 1, r + 1);
  }
}

void DiagonalBasis::backwards(Lanes const& x, Block& u) const {
  int const last = size() - 1;
  u.row(last).setConstant(smallest);
  for (int r = last; r > join_; --r) {
    Lanes next = x * u.row(r).array();
    if (r < last) next -= a_[r + 1] * u.row(r + 1).array();
    u.row(r - 1) = next / a_[r];
    if (r % 8 == 7 && u.row(r - 1).array().abs().maxCoeff() > largest) shrink(u, r - 1, last, r - 1);
  }
}

SkewHermitian<> matrix_of(SphereHarmonics const& f) {
  int const n = f.degrees();
  SkewHermitian<> w(n);
  double const scale = 1 / std::sqrt(QuantizedSphere(n).area_element());
  over_half_of_basis(n, [&](int m, int first, int count, DiagonalBasis::Block const& u) {
    int const size = n - m;
    // Even and odd l - m apart: their sum is the entry k, their difference the one opposite.
    Eigen::Matrix<double, DiagonalBasis::lanes, 4> parts =
        Eigen::Matrix<double, DiagonalBasis::lanes, 4>::Zero();
    for (int r = 0; r < size; ++r) {
      std::complex<double> const c = scale * f(m + r, m);
      parts.col(2 * (r % 2)) += c.real() * u.row(r).transpose();
      parts.col(2 * (r % 2) + 1) += c.imag() * u.row(r).transpose();
    }
    for (int i = 0; i < count; ++i) {
      int const k = first + i, opposite = size - 1 - k;
      auto const put = [&](int at, double real, double imaginary) {
        if (m == 0) imaginary = 0;
        w.imaginary(at, at + m) = w.imaginary(at + m, at) = real;
        w.real(at, at + m) = -imaginary, w.real(at + m, at) = imaginary;
      };
      put(k, parts(i, 0) + parts(i, 2), parts(i, 1) + parts(i, 3));
      if (opposite != k) put(opposite, parts(i, 0) - parts(i, 2), parts(i, 1) - parts(i, 3));
    }
  });
  return w;
}

SphereHarmonics harmonics_of(SkewHermitian<> const& w) {
  int const n = static_cast<int>(w.size());
  SphereHarmonics f(n);
  double const scale = std::sqrt(QuantizedSphere(n).area_element());
  over_half_of_basis(n, [&](int m, int first, int count, DiagonalBasis::Block const& u) {
    int const size = n - m;
    Eigen::Matrix<double, DiagonalBasis::lanes, 4> parts =
        Eigen::Matrix<double, DiagonalBasis::lanes, 4>::Zero();
    for (int i = 0; i < count; ++i) {
      int const k = first + i, opposite = size - 1 - k;
      double const real = w.imaginary(k, k + m), imaginary = -w.real(k, k + m);
      double const real_o = w.imaginary(opposite, opposite + m),
                   imaginary_o = -w.real(opposite, opposite + m);
      double const half = opposite == k ? 0.5 : 1;
      parts.row(i) << half * (real + real_o), half * (imaginary + imaginary_o), half * (real - real_o),
          half * (imaginary - imaginary_o);
    }
    parts *= scale;
    for (int r = 0; r < size; ++r) {
      auto const row = u.row(r);
      f(m + r, m) +=
          std::complex<double>(row.dot(parts.col(2 * (r % 2))), row.dot(parts.col(2 * (r % 2) + 1)));
    }
  });
  return f;
}

}  // namespace actio::sphere
