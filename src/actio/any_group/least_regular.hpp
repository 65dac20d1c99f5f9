// In which direction a Lagrangian is least regular.
#pragma once

#include <Eigen/Core>

#include "actio/any_group/legendre_velocity.hpp"
#include "actio/linear_algebra/eigenvalues.hpp"

namespace actio::systems {

/// The direction in which a symmetric matrix is least regular: a unit eigenvector of its eigenvalue of
/// smallest modulus, each component in a unit of its own.
struct LeastRegular {
  double smallest,            ///< modulus of an eigenvalue
      largest;                ///< modulus of an eigenvalue
  Eigen::VectorXd direction;  ///< of the smallest

  /// Of a symmetric matrix, in the units of \ref units_of.
  explicit LeastRegular(Eigen::MatrixXd const& m);
};

}  // namespace actio::systems
