// The powers and the eigenvalues of a vorticity matrix, from which its Casimir functions come.
#pragma once

#include <Eigen/Core>

#include "actio/skew_matrices/products.hpp"

namespace actio::scene {

/// \f$C_k = a\,\mathrm{Tr}((-iW)^k)\f$, k = 2 .. 8, by the products of a flow: three times three halves of a
/// real product.
/// @param area  a, the area that belongs to an eigenvalue
Eigen::VectorXd vorticity_casimirs(sphere::Products const& products, sphere::SkewHermitian<> const& w,
                                   double area);

/// The eigenvalues of -iW in ascending order. Of a flow that looks the same after 1/k of a turn about the
/// pole those of k blocks of the size N/k; of a zonal one the numbers on the diagonal.
Eigen::VectorXd vorticity_eigenvalues(sphere::SkewHermitian<> const& w);

}  // namespace actio::scene
