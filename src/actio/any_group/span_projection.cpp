#include <Eigen/Core>

#include "actio/any_group/span_projection.hpp"

namespace actio::systems {

namespace detail {

SpanProjection::SpanProjection(Rows const& basis) {
  for (auto const& e : basis) add(e, basis);
  find_dual();
  find_denominator();
}

void SpanProjection::add(Eigen::VectorXd const& e, Rows const& basis) {
  auto const count = static_cast<Index>(basis.size()), k = static_cast<Index>(orthonormal_.size());
  Eigen::VectorXd rest = e, made_of = Eigen::VectorXd::Unit(count, k);
  // Twice, so that rounding leaves no part behind.
  for (int pass = 0; pass < 2; ++pass)
    for (std::size_t i = 0; i < orthonormal_.size(); ++i) {
      double const along = orthonormal_[i].dot(rest);
      rest -= along * orthonormal_[i], made_of -= along * combination_[i];
    }
  double const left = rest.norm(), whole = e.norm();
  if (!(left > independent_ * whole)) refuse(k, made_of, left / whole);
  orthonormal_.push_back(rest / left), combination_.push_back(made_of / left);
}

void SpanProjection::refuse(Index k, Eigen::VectorXd const& made_of, double distance) {
  std::string sum;
  for (Index i = 0; i < k; ++i) {
    double const x = -made_of[i];
    if (!(std::abs(x) > independent_)) continue;
    sum += (sum.empty() ? (x < 0 ? "-" : "") : (x < 0 ? " - " : " + ")) + show(std::abs(x)) + " e_" +
           std::to_string(i + 1);
  }
  throw Singular("basis of an algebra",
                 "the matrices must be linearly independent, but e_" + std::to_string(k + 1) + " = " + sum +
                     "; relative distance of e_" + std::to_string(k + 1) + " from the span of those before",
                 distance, independent_);
}

void SpanProjection::find_dual() {
  for (std::size_t a = 0; a < orthonormal_.size(); ++a) {
    Eigen::VectorXd row = Eigen::VectorXd::Zero(orthonormal_[a].size());
    for (std::size_t i = a; i < orthonormal_.size(); ++i)
      row += combination_[i][static_cast<Index>(a)] * orthonormal_[i];
    dual.push_back(row);
  }
}

void SpanProjection::find_denominator() {
  auto const whole = [&](double times) {
    return std::all_of(dual.begin(), dual.end(), [&](Eigen::VectorXd const& row) {
      return std::all_of(row.begin(), row.end(), [&](double x) {
        return std::abs(times * x - std::round(times * x)) < 1e-14 * times && std::abs(times * x) < 1e6;
      });
    });
  };
  for (int times = 1; times <= 1000; ++times)
    if (whole(times)) {
      denominator = times;
      for (auto& row : dual)
        for (double& x : row) x = std::round(times * x);
      return;
    }
}

}  // namespace detail

}  // namespace actio::systems
