// Products of matrices by OpenBLAS, loaded when a scene first multiplies large ones.
//
// To link it would add to every start of the command, of which most have no use for it.
#pragma once

#include <string>
#include <vector>

#include "actio/skew_matrices/blas_products.hpp"

namespace actio::scene {

/// Products by the BLAS that was found when the command was built, on `threads` threads that are ours;
/// inside, the library works on one. Null where it cannot be loaded: then the products are Eigen's, slower.
/// @param remarks  what is said then
sphere::Products blas_products(int threads, std::vector<std::string>& remarks);

}  // namespace actio::scene
