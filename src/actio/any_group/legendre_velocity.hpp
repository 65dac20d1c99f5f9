// The Legendre map of a reduced Lagrangian at run time: velocities from momenta, and the energy.
#pragma once

#include <Eigen/Core>

#include "actio/any_group/reduced_system.hpp"
#include "actio/linear_algebra/iex.hpp"

namespace actio::systems {

/// Units of the components of a velocity in which a second differential of a Lagrangian has entries 1 or -1
/// on its diagonal, so that nothing depends on the units of the scene. Where an entry is zero, from its row.
Eigen::VectorXd units_of(Eigen::MatrixXd const& hessian);

/// The inverse of a matrix of second derivatives, and how well it is determined, in units of its components.
struct InverseInUnits {
  Eigen::MatrixXd matrix;  ///< the inverse; zero where there is none
  /// one over the product of the norms of the matrix and of its inverse, in the units
  double condition = 0;

  /// @param units  as \ref units_of has them
  InverseInUnits(Eigen::MatrixXd const& m, Eigen::VectorXd const& units);
};

/// \f$v\f$ with \f$\partial l/\partial v(v, a) = P\f$, with its work space. For one thread at a time.
class LegendreVelocity {
 public:
  /// Of a system that outlives it.
  explicit LegendreVelocity(ReducedSystem const& system);

  /// The momentum at a velocity; energy x time.
  /// @throws NotFinite  where the Lagrangian or its differential is no number
  std::vector<double> momentum(std::vector<double> const& v, std::vector<double> const& a) {
    evaluate(v, a);
    return {values_.begin() + 1, values_.begin() + 1 + static_cast<std::ptrdiff_t>(v.size())};
  }
  /// The energy \f$\langle P, v\rangle - l\f$ at a velocity.
  double energy(std::vector<double> const& v, std::vector<double> const& a);
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
  void solve(std::vector<double> const& p, std::vector<double> const& a, std::vector<double>& v);

 private:
  static constexpr double tolerance_ = 16 * 0x1p-52;

  void evaluate(std::vector<double> const& v, std::vector<double> const& a);
  /// The residual, and its size: in each component relative to what it is the sum of.
  double residual(std::vector<double> const& p, std::vector<double> const& a, std::vector<double> const& v);

  ReducedSystem const& system_;
  std::vector<double> inputs_, values_, work_;
  Eigen::MatrixXd hessian_;
  Eigen::VectorXd residual_;
};

}  // namespace actio::systems
