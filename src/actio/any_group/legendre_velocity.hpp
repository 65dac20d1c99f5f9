// The Legendre map of a reduced Lagrangian at run time: velocities from momenta, and the energy.
#pragma once

#include "actio/any_group/reduced_system.hpp"
#include "actio/numbers/iex.hpp"

namespace actio {

/// Units of the components of a velocity in which a second differential of a Lagrangian has entries 1 or -1
/// on its diagonal, so that nothing depends on the units of the scene. Where an entry is zero, from its row.
inline Eigen::VectorXd units_of(Eigen::MatrixXd const& hessian) {
  Eigen::VectorXd units(hessian.rows());
  for (Eigen::Index i = 0; i < units.size(); ++i) {
    double entry = std::abs(hessian(i, i));
    if (entry == 0) entry = hessian.row(i).cwiseAbs().maxCoeff();
    units[i] = entry > 0 ? 1 / std::sqrt(entry) : 1;
  }
  return units;
}

/// The inverse of a matrix of second derivatives, and how well it is determined, in units of its components.
struct InverseInUnits {
  Eigen::MatrixXd matrix;  ///< the inverse; zero where there is none
  /// one over the product of the norms of the matrix and of its inverse, in the units
  double condition = 0;

  /// @param units  as \ref units_of has them
  InverseInUnits(Eigen::MatrixXd const& m, Eigen::VectorXd const& units)
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
};

/// \f$v\f$ with \f$\partial l/\partial v(v, a) = P\f$, with its work space. For one thread at a time.
class LegendreVelocity {
 public:
  /// Of a system that outlives it.
  explicit LegendreVelocity(ReducedSystem const& system)
      : system_(system),
        inputs_(static_cast<std::size_t>(system.lagrangian.inputs)),
        values_(system.curvature.outputs.size()),
        hessian_(system.dimension(), system.dimension()),
        residual_(system.dimension()) {}

  /// The momentum at a velocity; energy x time.
  /// @throws NotFinite  where the Lagrangian or its differential is no number
  std::vector<double> momentum(std::vector<double> const& v, std::vector<double> const& a) {
    evaluate(v, a);
    return {values_.begin() + 1, values_.begin() + 1 + static_cast<std::ptrdiff_t>(v.size())};
  }
  /// The energy \f$\langle P, v\rangle - l\f$ at a velocity.
  double energy(std::vector<double> const& v, std::vector<double> const& a) {
    evaluate(v, a);
    double sum = -values_[0];
    for (std::size_t i = 0; i < v.size(); ++i) sum += values_[1 + i] * v[i];
    return sum;
  }
  /// \f$\partial^2l/\partial v^2\f$.
  Eigen::MatrixXd const& hessian(std::vector<double> const& v, std::vector<double> const& a) {
    evaluate(v, a);
    return hessian_;
  }

  /// The velocity that has the momentum, near the one that is handed in, by Newton's iteration. For a
  /// quadratic Lagrangian one step of it is exact.
  /// @throws Singular      where the second differential has no inverse on the way
  /// @throws NotConverged  after 60 iterations, each halved at most 30 times
  /// Accuracy: a few epsilon times the condition of the second differential.
  void solve(std::vector<double> const& p, std::vector<double> const& a, std::vector<double>& v) {
    std::vector<double> sizes;
    double size = residual(p, a, v);
    for (int iteration = 0; iteration < 60; ++iteration) {
      sizes.push_back(size);
      bool const done = size <= tolerance_;
      Eigen::VectorXd const units = units_of(hessian_);
      InverseInUnits const inverse(hessian_, units);
      if (!(inverse.condition > 0x1p-50))
        throw Singular("Legendre map",
                       "the second differential of the Lagrangian needs an inverse; condition",
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

 private:
  static constexpr double tolerance_ = 16 * 0x1p-52;

  void evaluate(std::vector<double> const& v, std::vector<double> const& a) {
    std::copy(v.begin(), v.end(), inputs_.begin());
    std::copy(a.begin(), a.end(), inputs_.begin() + static_cast<std::ptrdiff_t>(v.size()));
    system_.curvature(inputs_.data(), values_.data(), work_);
    std::size_t at = 1 + v.size();
    for (Eigen::Index i = 0; i < hessian_.rows(); ++i)
      for (Eigen::Index j = i; j < hessian_.cols(); ++j) hessian_(i, j) = hessian_(j, i) = values_[at++];
    for (double const x : values_)
      if (!std::isfinite(x)) throw NotFinite("the Lagrangian or one of its derivatives");
  }
  /// The residual, and its size: in each component relative to what it is the sum of.
  double residual(std::vector<double> const& p, std::vector<double> const& a, std::vector<double> const& v) {
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

  ReducedSystem const& system_;
  std::vector<double> inputs_, values_, work_;
  Eigen::MatrixXd hessian_;
  Eigen::VectorXd residual_;
};

}  // namespace actio
