#include "actio/quantized_sphere/averaged_stream.hpp"

namespace actio::sphere {
namespace {

double checked_length(double alpha, AveragedMetric metric) {
  if (!std::isfinite(alpha)) throw NotFinite("averaged flow: alpha");
  if (!(alpha >= 0)) throw OutsideDomain("averaged flow", "alpha must be 0 or more", alpha, 0);
  if (!(alpha * alpha * metric_shift(metric) < 1))
    throw OutsideDomain("averaged flow", "alpha must be below the root of 1/2 with the deformation", alpha,
                        std::sqrt(0.5));
  return alpha;
}

}  // namespace

AveragedStream::AveragedStream(int n, double alpha, AveragedMetric metric)
    : n_(QuantizedSphere(n).n),
      alpha_(checked_length(alpha, metric)),
      metric_(metric),
      laplacian_{Part::Zero(n, n), Part::Zero(n, n)},
      average_{Part::Zero(n, n), Part::Zero(n, n)} {
  double const square = alpha * alpha, shift = metric_shift(metric);
  for (int m = 0; m < n; ++m) {
    int const last = n - 1 - m;
    // -Delta = L D L^T; the main diagonal, where it has a kernel, is solved by sums.
    for (int k = 0; m > 0 && k <= last; ++k) {
      double const e = k > 0 ? laplacian_beside(n, k, m) * laplacian_.beside(k + m - 1, k - 1) : 0;
      laplacian_.pivot(k + m, k) = 1 / (-laplacian_diagonal(n, k, m) - e);
      if (k < last) laplacian_.beside(k + m, k) = laplacian_beside(n, k + 1, m) * laplacian_.pivot(k + m, k);
    }
    // 1 - alpha^2 (Delta + c) = U D U^T, begun at the other end.
    for (int k = last; k >= 0; --k) {
      double const beside = k < last ? square * laplacian_beside(n, k + 1, m) : 0;
      if (k < last) average_.beside(k + m, k) = beside * average_.pivot(k + 1 + m, k + 1);
      average_.pivot(k + m, k) =
          1 / (1 - square * (laplacian_diagonal(n, k, m) + shift) - beside * average_.beside(k + m, k));
    }
  }
}

void AveragedStream::solve(SkewHermitian<> const& w, SkewHermitian<>& p) const {
  if (p.size() != n_) p = SkewHermitian<>(n_);
  Part const* const given[] = {&w.real, &w.imaginary};
  Part* const found[] = {&p.real, &p.imaginary};
  // Forwards with L.
  for (int k = 0; k + 1 < n_; ++k) {
    int const rows = n_ - 1 - k;
    for (int part : {0, 1}) {
      auto now = found[part]->col(k).tail(rows).array();
      auto const right = given[part]->col(k).tail(rows).array();
      if (k == 0) now = -right;
      if (k > 0)
        now = laplacian_.beside.col(k - 1).segment(k, rows).array() *
                  found[part]->col(k - 1).segment(k, rows).array() -
              right;
    }
  }
  // Back with D and the transpose of L, which gives a column of what solves Poisson's equation, and with U.
  Eigen::ArrayXXd poisson = Eigen::ArrayXXd::Zero(n_, 2);
  for (int k = n_ - 2; k >= 0; --k) {
    int const rows = n_ - 1 - k;
    for (int part : {0, 1}) {
      auto now = found[part]->col(k).tail(rows).array();
      auto column = poisson.col(part).head(rows);
      column = laplacian_.pivot.col(k).tail(rows).array() * now +
               laplacian_.beside.col(k).tail(rows).array() * column;
      // The last row of a column has nothing after it.
      now.head(rows - 1) = column.head(rows - 1) + average_.beside.col(k).segment(k + 1, rows - 1).array() *
                                                       found[part]->col(k + 1).tail(rows - 1).array();
      now(rows - 1) = column(rows - 1);
    }
  }
  // Forwards with D and the transpose of U.
  for (int k = 0; k + 1 < n_; ++k) {
    int const rows = n_ - 1 - k;
    for (int part : {0, 1}) {
      auto now = found[part]->col(k).tail(rows).array();
      if (k == 0) now *= average_.pivot.col(k).tail(rows).array();
      if (k > 0)
        now = average_.pivot.col(k).tail(rows).array() * now +
              average_.beside.col(k - 1).segment(k, rows).array() *
                  found[part]->col(k - 1).segment(k, rows).array();
    }
  }
  solve_diagonal(w.imaginary, p.imaginary);
  p.real.diagonal().setZero();
  mirror_lower(p);
}

void AveragedStream::solve_diagonal(Part const& w, Part& p) const {
  solve_main_diagonal(w, p);
  for (int k = n_ - 2; k >= 0; --k) p(k, k) += average_.beside(k, k) * p(k + 1, k + 1);
  for (int k = 0; k < n_; ++k)
    p(k, k) = average_.pivot(k, k) * p(k, k) + (k > 0 ? average_.beside(k - 1, k - 1) * p(k - 1, k - 1) : 0);
  // The factor is smallest on the constants.
  p.diagonal().array() -= p.diagonal().sum() / n_;
}

}  // namespace actio::sphere
