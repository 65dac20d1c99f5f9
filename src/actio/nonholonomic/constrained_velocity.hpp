// Velocities that obey constraints: the projection of a momentum, and the reaction.
//
// The momentum P of a system is changed by a combination of the rows until its velocity obeys them,
//
//     dl/dv(w, a) = P + A(a, t)^T lambda,      c(w, a, t) = 0.
//
// For a quadratic Lagrangian this is the orthogonal projection in the metric of the kinetic energy, what a
// blow does that makes a body roll.
#pragma once

#include <Eigen/Core>

#include "actio/any_group/legendre_velocity.hpp"
#include "actio/nonholonomic/velocity_constraints.hpp"

namespace actio::systems {

/// Units of velocities and multipliers in which the derivative of a constrained equation, with constraints in
/// its last rows, has entries of size 1.
/// @param dimension  how many of its rows are equations of momenta
Eigen::VectorXd units_with_multipliers(Eigen::MatrixXd const& derivative, int dimension);

/// Solves for velocities on the constraints, with its work space. For one thread at a time.
class ConstrainedVelocity {
 public:
  /// Of a system and constraints that outlive it.
  ConstrainedVelocity(ReducedSystem const& system, VelocityConstraints const& constraints);

  /// The velocity near the one that is handed in, and the multipliers.
  /// @param p       momentum P; energy x time
  /// @param a       vectors
  /// @param t       time
  /// @param v       near which the velocity is looked for; becomes it
  /// @param lambda  likewise the multipliers
  /// @throws Singular      where rows depend on each other, or the Lagrangian is not regular along them
  /// @throws NotConverged  after 60 iterations
  /// @throws NotFinite     where a formula or a derivative of it is no number
  /// Accuracy: a few epsilon times the condition; the constraints to a few epsilon of their terms.
  void solve(std::vector<double> const& p, std::vector<double> const& a, double t, std::vector<double>& v,
             std::vector<double>& lambda);

  /// \f$P + A^T\lambda\f$.
  std::vector<double> momentum(std::vector<double> p, std::vector<double> const& a, double t,
                               std::vector<double> const& lambda);

  /// How far a velocity is from the constraints: the largest \f$|c_i|\f$ relative to what the row is of a
  /// velocity of this size, in the metric of the Lagrangian; 1 where it is as large as that or larger.
  double defect(std::vector<double> const& v, std::vector<double> const& a, double t);

  /// Refuses rows that depend on each other, by more than 1e-10 in the metric of the Lagrangian.
  /// @throws Singular  with the number of the first that is a combination of those before
  void require_independent(std::vector<double> const& v, std::vector<double> const& a, double t);

  /// The multipliers of the motion at a velocity that obeys the constraints: reactions, force along each row.
  ///
  /// With \f$\tfrac{d}{dt}\partial l/\partial v = \pm(\mathrm{ad}^*_vp - J) + A^T\lambda\f$ and
  /// \f$\tfrac{d}{dt}c = 0\f$ they are a function of the state, as accurate as that.
  /// @return  \f$\lambda\f$; energy over the unit of the row
  std::vector<double> reaction(std::vector<double> const& v, std::vector<double> const& a, double t);

 private:
  static constexpr double tolerance_ = 16 * 0x1p-52;

  /// The residual of the equations, and its size, each relative to what it is the sum of.
  double residual(std::vector<double> const& p, std::vector<double> const& a, double t,
                  std::vector<double> const& v, std::vector<double> const& lambda);
  /// \f$\begin{pmatrix}\partial^2l/\partial v^2 & -A^T\\ A & 0\end{pmatrix}\f$.
  void set_matrix(std::vector<double> const& v, std::vector<double> const& a);
  Eigen::MatrixXd inverse() const;
  /// What each row is, at most, of a velocity whose largest component is that of this one, in the units of
  /// the matrix that was set.
  Eigen::VectorXd sizes_at(std::vector<double> const& v) const;

  ReducedSystem const& system_;
  VelocityConstraints const& constraints_;
  LegendreVelocity legendre_;
  ConstraintValues<double> at_;
  Eigen::MatrixXd matrix_;
  Eigen::VectorXd residual_;
};

}  // namespace actio::systems
