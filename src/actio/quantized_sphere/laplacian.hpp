// The Laplacian of the quantised sphere, and its inverse.
//
// Delta W = -sum_j [S_j, [S_j, W]] (Hoppe and Yau) has the eigenvalues -l(l + 1), l = 0 .. N - 1, each 2l + 1
// times. It takes each diagonal of W to itself: with w_k = W(k + m, k), k = 0 .. N - m - 1,
//
//   (Delta w)_k = d_k w_k + e_k w_{k-1} + e_{k+1} w_{k+1},
//   d_k = -((N - 1)(2k + 1 + m) - 2k(k + m)),   e_k = sqrt(k (N - k) (k + m) (N - k - m)).
//
// The diagonals are independent of one another, and the columns of a matrix hold entries of neighbouring
// diagonals side by side: all recursions run over the columns, with the diagonals as lanes.
#pragma once

#include <vector>

#include "actio/quantized_sphere/quantized_sphere.hpp"

namespace actio::sphere {

/// \f$d_k\f$ of the diagonal m.
inline double laplacian_diagonal(int n, int k, int m) {
  return -((n - 1.0) * (2.0 * k + 1 + m) - 2.0 * k * (static_cast<double>(k) + m));
}
/// \f$e_k\f$ of the diagonal m.
inline double laplacian_beside(int n, int k, int m) {
  double const nn = n, kk = k, mm = m;
  return std::sqrt(kk * (nn - kk)) * std::sqrt((kk + mm) * (nn - kk - mm));
}

/// The main diagonal of \f$\Delta^{-1}\f$, with the sum zero, of W less its mean: the sums of the first k + 1
/// equations are \f$(k+1)(N-1-k)\,(p_{k+1}-p_k)\f$, and two sums solve them.
void solve_main_diagonal(SkewHermitian<>::Part const& w, SkewHermitian<>::Part& p);

/// \f$\Delta\f$ on u(N), and \f$\Delta^{-1}\f$ on the matrices with trace zero.
///
/// \snippet sphere.cpp sphere_laplacian
class SphereLaplacian {
 public:
  /// Factors the matrices of the diagonals; N^2 numbers are stored.
  explicit SphereLaplacian(int n);
  int size() const { return n_; }

  /// \f$\Delta W\f$. O(N^2) operations.
  SkewHermitian<> apply(SkewHermitian<> const& w) const;
  /// The solution P with trace zero of \f$\Delta P = W - \mathrm{Tr}(W)/N\f$. O(N^2) operations.
  ///
  /// Accuracy: relative to |P| about \f$10^{-16}N\f$.
  void solve(SkewHermitian<> const& w, SkewHermitian<>& p) const;
  /// The same as a value.
  SkewHermitian<> solve(SkewHermitian<> const& w) const {
    SkewHermitian<> p(n_);
    solve(w, p);
    return p;
  }

 private:
  using Part = SkewHermitian<>::Part;

  double diagonal(int k, int m) const { return laplacian_diagonal(n_, k, m); }
  double off_diagonal(int k, int m) const { return laplacian_beside(n_, k, m); }

  void apply(Part const& w, Part& out) const;
  /// Below the diagonal.
  void solve(Part const& w, Part& p) const;
  int n_;
  Part above_, pivot_;
};

}  // namespace actio::sphere
