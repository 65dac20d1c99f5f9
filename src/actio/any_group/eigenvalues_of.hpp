// The eigenvalues of a real matrix, from the GNU Scientific Library.
#pragma once

#include <Eigen/Core>

#include "actio/linear_algebra/eigenvalues.hpp"

namespace actio::systems {

/// All eigenvalues, in no order.
/// @throws NotFinite     where an entry is no number
/// @throws NotConverged  where the QR iteration does not end
Eigen::VectorXcd eigenvalues_of(Eigen::MatrixXd a);

}  // namespace actio::systems
