#include <Eigen/Core>

#include "actio/any_group/legendre_velocity.hpp"

namespace actio::systems {

Eigen::VectorXd units_of(Eigen::MatrixXd const& hessian) {
  Eigen::VectorXd units(hessian.rows());
  for (Eigen::Index i = 0; i < units.size(); ++i) {
    double entry = std::abs(hessian(i, i));
    if (entry == 0) entry = hessian.row(i).cwiseAbs().maxCoeff();
    units[i] = entry > 0 ? 1 / std::sqrt(entry) : 1;
  }
  return units;
}

InverseInUnits::InverseInUnits(Eigen::MatrixXd const& m, Eigen::VectorXd const& units)
    : matrix(Eigen::MatrixXd::Zero(m.rows(), m.cols())) {
  Eigen::MatrixXd const scaled = units.asDiagonal() * m * units.asDiagonal();
  if (!is_finite(scaled)) return;
  try {
    Eigen::MatrixXd const inverse = inverse_matrix(scaled, "second derivative");
    if (!is_finite(inverse)) return;
    condition = 1 / (row_norm(scaled) * row_norm(inverse));
    matrix = units.asDiagonal() * inverse * units.asDiagonal();
  } catch (Singular const&) {
  }
}

LegendreVelocity::LegendreVelocity(ReducedSystem const& system)
    : system_(system),
      inputs_(static_cast<std::size_t>(system.lagrangian.inputs)),
      values_(system.curvature.outputs.size()),
      hessian_(system.dimension(), system.dimension()),
      residual_(system.dimension()) {}

double LegendreVelocity::energy(std::vector<double> const& v, std::vector<double> const& a) {
  evaluate(v, a);
  double sum = -values_[0];
  for (std::size_t i = 0; i < v.size(); ++i) sum += values_[1 + i] * v[i];
  return sum;
}

void LegendreVelocity::solve(std::vector<double> const& p, std::vector<double> const& a,
                             std::vector<double>& v) {
  std::vector<double> sizes;
  double size = residual(p, a, v);
  for (int iteration = 0; iteration < 60; ++iteration) {
    sizes.push_back(size);
    bool const done = size <= tolerance_;
    Eigen::VectorXd const units = units_of(hessian_);
    InverseInUnits const inverse(hessian_, units);
    if (!(inverse.condition > 0x1p-50))
      throw Singular("Legendre map", "the second differential of the Lagrangian needs an inverse; condition",
                     inverse.condition, 0x1p-50);
    Eigen::VectorXd const update = inverse.matrix * residual_;
    std::vector<double> const from = v;
    double const before = size;
    for (double fraction = 1; fraction > 1e-9; fraction /= 2) {
      for (std::size_t i = 0; i < v.size(); ++i)
        v[i] = from[i] - fraction * update[static_cast<Eigen::Index>(i)];
      size = residual(p, a, v);
      if (size <= before || done) break;
    }
    if (done || (size <= 64 * tolerance_ && size >= before / 2)) return;
    if (!(size <= before)) break;
  }
  throw NotConverged("Legendre map", sizes, tolerance_);
}

void LegendreVelocity::evaluate(std::vector<double> const& v, std::vector<double> const& a) {
  std::copy(v.begin(), v.end(), inputs_.begin());
  std::copy(a.begin(), a.end(), inputs_.begin() + static_cast<std::ptrdiff_t>(v.size()));
  system_.curvature(inputs_.data(), values_.data(), work_);
  std::size_t at = 1 + v.size();
  for (Eigen::Index i = 0; i < hessian_.rows(); ++i)
    for (Eigen::Index j = i; j < hessian_.cols(); ++j) hessian_(i, j) = hessian_(j, i) = values_[at++];
  for (double const x : values_)
    if (!std::isfinite(x)) throw NotFinite("the Lagrangian or one of its derivatives");
}

double LegendreVelocity::residual(std::vector<double> const& p, std::vector<double> const& a,
                                  std::vector<double> const& v) {
  try {
    evaluate(v, a);
  } catch (NotFinite const&) {
    return HUGE_VAL;
  }
  double largest = 0;
  for (std::size_t i = 0; i < v.size(); ++i) {
    auto const row = static_cast<Eigen::Index>(i);
    double const r = residual_[row] = values_[1 + i] - p[i];
    double scale = std::abs(p[i]) + std::abs(values_[1 + i]);
    for (std::size_t j = 0; j < v.size(); ++j)
      scale += std::abs(hessian_(row, static_cast<Eigen::Index>(j)) * v[j]);
    if (r != 0) largest = std::max(largest, std::abs(r) / scale);
  }
  return largest;
}

}  // namespace actio::systems
