// The Legendre map of a reduced Lagrangian at run time: velocities from momenta, and the energy.
#pragma once

#include <Eigen/Eigenvalues>
#include <Eigen/LU>

#include "actio/any_group/reduced_system.hpp"

namespace actio {

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
    double const target = norm(p);
    std::vector<double> sizes;
    double size = residual(p, a, v);
    for (int iteration = 0; iteration < 60; ++iteration) {
      sizes.push_back(size);
      double const scale = target + hessian_.cwiseAbs().rowwise().sum().maxCoeff() * norm(v);
      bool const done = size <= 16 * epsilon_ * scale;
      auto const lu = hessian_.partialPivLu();
      Eigen::VectorXd const update = lu.solve(residual_);
      if (!update.allFinite() || !(lu.rcond() > epsilon_))
        throw Singular("Legendre map", "the second differential of the Lagrangian needs an inverse; condition",
                       lu.rcond(), epsilon_);
      std::vector<double> const from = v;
      double const before = size;
      for (double fraction = 1; fraction > 1e-9; fraction /= 2) {
        for (std::size_t i = 0; i < v.size(); ++i)
          v[i] = from[i] - fraction * update[static_cast<Eigen::Index>(i)];
        size = residual(p, a, v);
        if (size <= before || done) break;
      }
      if (done || (size <= 1024 * epsilon_ * scale && size >= before / 2)) return;
      if (!(size <= before)) break;
    }
    throw NotConverged("Legendre map", sizes, 16 * epsilon_);
  }

 private:
  static constexpr double epsilon_ = 0x1p-52;
  static double norm(std::vector<double> const& x) {
    double largest = 0;
    for (double const part : x) largest = std::max(largest, std::abs(part));
    return largest;
  }

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
  double residual(std::vector<double> const& p, std::vector<double> const& a, std::vector<double> const& v) {
    try {
      evaluate(v, a);
    } catch (NotFinite const&) {
      return HUGE_VAL;
    }
    double largest = 0;
    for (std::size_t i = 0; i < v.size(); ++i) {
      residual_[static_cast<Eigen::Index>(i)] = values_[1 + i] - p[i];
      largest = std::max(largest, std::abs(values_[1 + i] - p[i]));
    }
    return largest;
  }

  ReducedSystem const& system_;
  std::vector<double> inputs_, values_, work_;
  Eigen::MatrixXd hessian_;
  Eigen::VectorXd residual_;
};

/// The direction in which a symmetric matrix is least regular: a unit eigenvector of its eigenvalue of
/// smallest modulus.
struct LeastRegular {
  double smallest,            ///< modulus of an eigenvalue
      largest;                ///< modulus of an eigenvalue
  Eigen::VectorXd direction;  ///< of the smallest

  /// Of a symmetric matrix.
  explicit LeastRegular(Eigen::MatrixXd const& m) {
    Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> const solved(m);
    Eigen::Index at = 0;
    smallest = solved.eigenvalues().cwiseAbs().minCoeff(&at);
    largest = solved.eigenvalues().cwiseAbs().maxCoeff();
    direction = solved.eigenvectors().col(at);
  }
};

}  // namespace actio
