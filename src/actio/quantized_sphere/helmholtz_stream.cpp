#include "actio/quantized_sphere/helmholtz_stream.hpp"

namespace actio::sphere {

HelmholtzStream::HelmholtzStream(int n, double gamma)
    : n_(QuantizedSphere(n).n), gamma_(gamma), above_(n, n), pivot_(n, n) {
  if (!std::isfinite(gamma)) throw NotFinite("Helmholtz: gamma");
  if (!(gamma > 0)) throw OutsideDomain("Helmholtz", "gamma must be above 0", gamma, 0);
  for (int k = 0; k < n; ++k)
    for (int m = 0; m + k < n; ++m) {
      double const e = laplacian_beside(n, k, m), d = laplacian_diagonal(n, k, m) - gamma;
      above_(k + m, k) = k == 0 ? 0 : e * pivot_(k + m - 1, k - 1);
      pivot_(k + m, k) = 1 / (-d - (k == 0 ? 0 : e * above_(k + m, k)));
    }
}

void HelmholtzStream::solve(SkewHermitian<> const& w, SkewHermitian<>& p) const {
  if (p.size() != n_) p = SkewHermitian<>(n_);
  solve(w.real, p.real, 0), solve(w.imaginary, p.imaginary, w.imaginary.diagonal().sum() / n_);
  // Rounding is 1/gamma times as large in the trace as in the rest.
  double const trace = p.imaginary.diagonal().sum();
  p.imaginary.diagonal().array() -= trace / n_;
  mirror_lower(p);
}

void HelmholtzStream::solve(Part const& w, Part& p, double mean) const {
  for (int k = 0; k < n_; ++k) {
    int const rows = n_ - k;
    p.col(k).tail(rows) = -w.col(k).tail(rows);
    p(k, k) += mean;
    if (k > 0)
      p.col(k).tail(rows).array() +=
          above_.col(k).tail(rows).array() * p.col(k - 1).segment(k - 1, rows).array();
  }
  for (int k = n_ - 1; k >= 0; --k) {
    int const rows = n_ - k;
    p.col(k).tail(rows).array() *= pivot_.col(k).tail(rows).array();
    if (rows > 1)
      p.col(k).segment(k, rows - 1).array() +=
          above_.col(k + 1).tail(rows - 1).array() * p.col(k + 1).tail(rows - 1).array();
  }
}

}  // namespace actio::sphere
