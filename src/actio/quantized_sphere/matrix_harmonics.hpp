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

#include <Eigen/Core>

#include "actio/quantized_sphere/quantized_sphere.hpp"

namespace actio::sphere {

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
  DiagonalBasis(int n, int m);
  /// How many k there are, and l.
  int size() const { return n_ - m_; }

  /// \f$u_l(k)\f$ for k from `first` on: the rows are l = m, m + 1, ...; lanes beyond the last k hold what
  /// may be overwritten.
  void block(int first, Block& u) const;

 private:
  using Lanes = Eigen::Array<double, 1, lanes>;
  static constexpr double smallest = 1e-250, largest = 1e250;

  /// That of \f$T_{mm}\f$.
  double sign() const { return m_ % 2 == 0 ? 1 : -1; }

  void forwards(Lanes const& x, Block& u) const;
  void backwards(Lanes const& x, Block& u) const;
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
///
/// \snippet sphere.cpp matrix_of
/// @param f  of degrees below N; the imaginary part of \f$f_{l0}\f$ is not used
SkewHermitian<> matrix_of(SphereHarmonics const& f);

/// The coefficients \f$f_{lm} = \tfrac{4\pi}N\mathrm{Tr}(T_{lm}^*(-iW))\f$ of a matrix. O(N^3) operations,
/// O(N^2) memory.
///
/// \snippet sphere.cpp matrix_of
SphereHarmonics harmonics_of(SkewHermitian<> const& w);

}  // namespace actio::sphere
