// The largest step of the Moser-Veselov scheme where n is large: the same maximum as in largest_step.hpp, by
// products of a matrix and a vector.
#pragma once

#include <Eigen/Core>

#include <algorithm>
#include <vector>

#include "actio/rigid_body/largest_step.hpp"

namespace actio::bodies {
namespace detail {

/// The largest eigenvalue of a symmetric tridiagonal matrix, by bisection on the signs of its pivots.
double largest_of_tridiagonal(std::vector<double> const& diagonal, std::vector<double> const& beside);

/// \f$s\,\rho\big((s^2+\Lambda^2)^{-1/2}\,iM\,(s^2+\Lambda^2)^{-1/2}\big)\f$ by Lanczos' method on the
/// negative square of the skew matrix.
class SpinAgainstInertia {
 public:
  SpinAgainstInertia(Eigen::VectorXd lambda, Eigen::MatrixXd m);

  /// @param s       positive
  /// @param digits  relative change of the result below which the iteration ends
  double operator()(double s, double digits);

 private:
  Eigen::VectorXd minus_square(Eigen::VectorXd const& w, Eigen::VectorXd const& x) const {
    return apply(w, apply(w, x)) * -1;
  }
  Eigen::VectorXd apply(Eigen::VectorXd const& w, Eigen::VectorXd const& x) const {
    Eigen::VectorXd y = Eigen::VectorXd::Zero(x.size());
    for (Eigen::Index j = 0; j < x.size(); ++j) y += m_.col(j) * (w[j] * x[j]);
    return y.cwiseProduct(w);
  }
  Eigen::VectorXd lambda_;
  Eigen::MatrixXd m_;
  Eigen::VectorXd start_;
};

}  // namespace detail

/// \ref largest_step for n in the hundreds, in seconds: n^2 operations for what takes n^3 there.
///
/// @throws OutsideDomain  where a \f$\Lambda_i\f$ is negative
/// Accuracy: relative 1e-6 or so.
double largest_step_n(Inertia<Eigen::Dynamic> const& inertia, Momentum<SO<Eigen::Dynamic>, double> const& pi);

}  // namespace actio::bodies
