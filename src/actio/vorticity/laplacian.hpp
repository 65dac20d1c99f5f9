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

#include "actio/vorticity/quantized_sphere.hpp"

namespace actio {

/// \f$d_k\f$ of the diagonal m.
inline double laplacian_diagonal(int n, int k, int m) {
  return -((n - 1.0) * (2.0 * k + 1 + m) - 2.0 * k * (static_cast<double>(k) + m));
}
/// \f$e_k\f$ of the diagonal m.
inline double laplacian_beside(int n, int k, int m) {
  double const nn = n, kk = k, mm = m;
  return std::sqrt(kk * (nn - kk)) * std::sqrt((kk + mm) * (nn - kk - mm));
}

/// \f$\Delta\f$ on u(N), and \f$\Delta^{-1}\f$ on the matrices with trace zero.
class SphereLaplacian {
 public:
  /// Factors the matrices of the diagonals; N^2 numbers are stored.
  explicit SphereLaplacian(int n) : n_(QuantizedSphere(n).n), above_(n, n), pivot_(n, n) {
    for (int k = 0; k < n; ++k)
      for (int m = 1; m + k < n; ++m) {
        double const e = off_diagonal(k, m), d = diagonal(k, m);
        // -Delta = L D L^T; D, and the factor of L in front of the row before.
        above_(k + m, k) = k == 0 ? 0 : e * pivot_(k + m - 1, k - 1);
        pivot_(k + m, k) = 1 / (-d - (k == 0 ? 0 : e * above_(k + m, k)));
      }
  }
  int size() const { return n_; }

  /// \f$\Delta W\f$. O(N^2) operations.
  SkewHermitian<> apply(SkewHermitian<> const& w) const {
    SkewHermitian<> out(n_);
    apply(w.real, out.real), apply(w.imaginary, out.imaginary);
    mirror_lower(out);
    return out;
  }
  /// The solution P with trace zero of \f$\Delta P = W - \mathrm{Tr}(W)/N\f$. O(N^2) operations.
  ///
  /// Accuracy: relative to |P| about \f$10^{-16}N\f$.
  void solve(SkewHermitian<> const& w, SkewHermitian<>& p) const {
    if (p.size() != n_) p = SkewHermitian<>(n_);
    solve(w.real, p.real), solve(w.imaginary, p.imaginary);
    solve_diagonal(w.imaginary, p.imaginary);
    p.real.diagonal().setZero();
    mirror_lower(p);
  }
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

  void apply(Part const& w, Part& out) const {
    for (int k = 0; k < n_; ++k)
      for (int m = 0; m + k < n_; ++m) {
        double sum = diagonal(k, m) * w(k + m, k);
        if (k > 0) sum += off_diagonal(k, m) * w(k + m - 1, k - 1);
        if (k + m + 1 < n_) sum += off_diagonal(k + 1, m) * w(k + m + 1, k + 1);
        out(k + m, k) = sum;
      }
  }
  /// Below the diagonal.
  void solve(Part const& w, Part& p) const {
    for (int k = 0; k < n_; ++k) {
      auto const rows = n_ - 1 - k;
      auto now = p.col(k).tail(rows).array();
      if (k == 0) now = -w.col(k).tail(rows).array();
      if (k > 0)
        now = -w.col(k).tail(rows).array() +
              above_.col(k).tail(rows).array() * p.col(k - 1).segment(k, rows).array();
    }
    for (int k = n_ - 2; k >= 0; --k) {
      auto const rows = n_ - 1 - k;
      p.col(k).tail(rows).array() *= pivot_.col(k).tail(rows).array();
      // The last row of a column has nothing after it.
      if (rows > 1)
        p.col(k).segment(k + 1, rows - 1).array() +=
            above_.col(k + 1).tail(rows - 1).array() * p.col(k + 1).tail(rows - 1).array();
    }
  }
  /// On the diagonal the sums of the first k + 1 equations are \f$(k+1)(N-1-k)\,(p_{k+1}-p_k)\f$: two sums.
  void solve_diagonal(Part const& w, Part& p) const {
    double const mean = w.diagonal().sum() / n_;
    double flux = 0, place = 0, sum = 0;
    p(0, 0) = 0;
    for (int k = 0; k + 1 < n_; ++k) {
      flux += w(k, k) - mean;
      place += flux / ((k + 1.0) * (n_ - 1.0 - k));
      p(k + 1, k + 1) = place, sum += place;
    }
    p.diagonal().array() -= sum / n_;
  }
  int n_;
  Part above_, pivot_;
};

}  // namespace actio
