#include "actio/quantized_sphere/laplacian.hpp"

namespace actio::sphere {

SphereLaplacian::SphereLaplacian(int n) : n_(QuantizedSphere(n).n), above_(n, n), pivot_(n, n) {
  for (int k = 0; k < n; ++k)
    for (int m = 1; m + k < n; ++m) {
      double const e = off_diagonal(k, m), d = diagonal(k, m);
      // -Delta = L D L^T; D, and the factor of L in front of the row before.
      above_(k + m, k) = k == 0 ? 0 : e * pivot_(k + m - 1, k - 1);
      pivot_(k + m, k) = 1 / (-d - (k == 0 ? 0 : e * above_(k + m, k)));
    }
}

SkewHermitian<> SphereLaplacian::apply(SkewHermitian<> const& w) const {
  SkewHermitian<> out(n_);
  apply(w.real, out.real), apply(w.imaginary, out.imaginary);
  mirror_lower(out);
  return out;
}

void SphereLaplacian::solve(SkewHermitian<> const& w, SkewHermitian<>& p) const {
  if (p.size() != n_) p = SkewHermitian<>(n_);
  solve(w.real, p.real), solve(w.imaginary, p.imaginary);
  solve_main_diagonal(w.imaginary, p.imaginary);
  p.real.diagonal().setZero();
  mirror_lower(p);
}

void SphereLaplacian::apply(Part const& w, Part& out) const {
  for (int k = 0; k < n_; ++k)
    for (int m = 0; m + k < n_; ++m) {
      double sum = diagonal(k, m) * w(k + m, k);
      if (k > 0) sum += off_diagonal(k, m) * w(k + m - 1, k - 1);
      if (k + m + 1 < n_) sum += off_diagonal(k + 1, m) * w(k + m + 1, k + 1);
      out(k + m, k) = sum;
    }
}

void SphereLaplacian::solve(Part const& w, Part& p) const {
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

void solve_main_diagonal(SkewHermitian<>::Part const& w, SkewHermitian<>::Part& p) {
  auto const n = w.rows();
  double const mean = w.diagonal().sum() / static_cast<double>(n);
  double flux = 0, place = 0, sum = 0;
  p(0, 0) = 0;
  for (int k = 0; k + 1 < n; ++k) {
    flux += w(k, k) - mean;
    place += flux / ((k + 1.0) * (static_cast<double>(n) - 1 - k));
    p(k + 1, k + 1) = place, sum += place;
  }
  p.diagonal().array() -= sum / static_cast<double>(n);
}

}  // namespace actio::sphere
