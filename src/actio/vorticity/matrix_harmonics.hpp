// Spherical harmonics as matrices, and back, in O(N^2) memory.
//
// The matrix T_lm of the harmonic Y_lm has one diagonal, that of the entries (k, k + m). It is normalised as
// the function is, 4 pi/N Tr(T_lm^* T_lm) = 1, with the Condon-Shortley phase. On the diagonal m the numbers
// u_l(k) = sqrt(4 pi/N) T_lm(k, k + m) are an orthogonal matrix, and multiplication by the third coordinate
// acts on them as cos(theta) does on Y_lm:
//
//   x_k u_l(k) = a_{l+1} u_{l+1}(k) + a_l u_{l-1}(k),   x_k = (N - 1 - m)/2 - k,
//   a_l = 1/2 sqrt((l^2 - m^2)(N^2 - l^2)/(4 l^2 - 1)).
//
// So for each k the numbers u_l(k), l = m .. N - 1, are the eigenvector of a tridiagonal matrix, whose
// eigenvalue x_k is known without error and is 1 away from the next. It is found by the recurrence from both
// ends: from each it grows towards the middle, l^2 = m N, where no u is in its decay, and where the two are
// joined. Neighbouring k share the a_l, and are the lanes of a block. Nothing is stored but one block.
#pragma once

#include "actio/vorticity/quantized_sphere.hpp"

namespace actio {

/// The coefficients of a real function on the sphere: \f$f = \sum_{l,m}f_{lm}Y_{lm}\f$ with
/// \f$f_{l,-m} = (-1)^m\bar f_{lm}\f$, in orthonormal complex harmonics with the Condon-Shortley phase.
struct SphereHarmonics {
  /// (l, m), m >= 0; zero where m > l
  Eigen::MatrixXcd coefficient;

  SphereHarmonics() = default;
  /// Zero, of the degrees below n.
  explicit SphereHarmonics(int n) : coefficient(Eigen::MatrixXcd::Zero(n, n)) {}
  /// The degrees go up to one below this.
  int degrees() const { return static_cast<int>(coefficient.rows()); }
  std::complex<double>& operator()(int l, int m) { return coefficient(l, m); }
  std::complex<double> operator()(int l, int m) const { return coefficient(l, m); }
  /// \f$\sum_m|f_{lm}|^2\f$ over all m, from -l to l.
  double power(int l) const { return 2 * coefficient.row(l).squaredNorm() - std::norm(coefficient(l, 0)); }
};

/// The columns of the basis for one diagonal, a block at a time.
class DiagonalBasis {
 public:
  /// The most k of a block.
  static constexpr int lanes = 32;
  /// One row for each l, one column for each k.
  using Block = Eigen::Matrix<double, Eigen::Dynamic, lanes, Eigen::RowMajor>;

  /// Of the diagonal m of matrices of the size n, 0 <= m < n.
  DiagonalBasis(int n, int m) : n_(n), m_(m), a_(n - m + 1) {
    for (int l = m; l <= n; ++l) {
      double const ll = l, nn = n, mm = m;
      a_[l - m] = l == m || l == n ? 0
                                   : 0.5 * std::sqrt((ll - mm) * (ll + mm) * (nn - ll) * (nn + ll) /
                                                     ((2 * ll - 1) * (2 * ll + 1)));
    }
    join_ = std::clamp(static_cast<int>(std::lround(std::sqrt(static_cast<double>(m) * n))) - m, 0,
                       std::max(0, n - m - 2));
  }
  /// How many k there are, and l.
  int size() const { return n_ - m_; }

  /// \f$u_l(k)\f$ for k from `first` on: the rows are l = m, m + 1, ...; lanes beyond the last k hold what
  /// may be overwritten.
  void block(int first, Block& u) const {
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

 private:
  using Lanes = Eigen::Array<double, 1, lanes>;
  static constexpr double smallest = 1e-250, largest = 1e250;

  /// That of \f$T_{mm}\f$.
  double sign() const { return m_ % 2 == 0 ? 1 : -1; }

  void forwards(Lanes const& x, Block& u) const {
    u.row(0).setConstant(smallest);
    for (int r = 0; r <= join_; ++r) {
      Lanes next = x * u.row(r).array();
      if (r > 0) next -= a_[r] * u.row(r - 1).array();
      u.row(r + 1) = next / a_[r + 1];
      if (r % 8 == 7 && u.row(r + 1).array().abs().maxCoeff() > largest) shrink(u, 0, r + 1, r + 1);
    }
  }
  void backwards(Lanes const& x, Block& u) const {
    int const last = size() - 1;
    u.row(last).setConstant(smallest);
    for (int r = last; r > join_; --r) {
      Lanes next = x * u.row(r).array();
      if (r < last) next -= a_[r + 1] * u.row(r + 1).array();
      u.row(r - 1) = next / a_[r];
      if (r % 8 == 7 && u.row(r - 1).array().abs().maxCoeff() > largest) shrink(u, r - 1, last, r - 1);
    }
  }
  /// Lanes that have grown too large get smaller as a whole; what gets lost is less than 1e-250 of the rest.
  static void shrink(Block& u, int from, int to, int newest) {
    for (int i = 0; i < lanes; ++i)
      if (std::abs(u(newest, i)) > largest)
        for (int r = from; r <= to; ++r) u(r, i) *= smallest;
  }

  int n_, m_, join_;
  std::vector<double> a_;  ///< a_l at l - m
};

/// Calls `use(m, basis, first, lanes, u)` for blocks that hold the first half of the k of each diagonal; the
/// second half is \f$u_l(N-1-m-k) = (-1)^{l-m}u_l(k)\f$.
template <class Use>
void over_half_of_basis(int n, Use const& use) {
  DiagonalBasis::Block u;
  for (int m = 0; m < n; ++m) {
    DiagonalBasis const basis(n, m);
    int const half = (basis.size() + 1) / 2;
    for (int first = 0; first < half; first += DiagonalBasis::lanes) {
      basis.block(first, u);
      use(m, first, std::min(DiagonalBasis::lanes, half - first), u);
    }
  }
}

/// The matrix \f$W = i\sum f_{lm}T_{lm}\f$ of a real function. O(N^3) operations, O(N^2) memory.
/// @param f  of degrees below N; the imaginary part of \f$f_{l0}\f$ is not used
inline SkewHermitian<> matrix_of(SphereHarmonics const& f) {
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

/// The coefficients \f$f_{lm} = \tfrac{4\pi}N\mathrm{Tr}(T_{lm}^*(-iW))\f$ of a matrix. O(N^3) operations,
/// O(N^2) memory.
inline SphereHarmonics harmonics_of(SkewHermitian<> const& w) {
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

}  // namespace actio
