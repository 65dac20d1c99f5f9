// What multiplies the matrices of a flow on the sphere: chosen once, from its size and its symmetry.
#pragma once

#include <string>
#include <vector>

#include "actio/skew_matrices/products.hpp"

namespace actio::scene {

/// Products of matrices of a size: by OpenBLAS where they are large enough for it to be loaded, on several
/// threads where they are larger still; by all ranks where there are several.
/// @param remarks  what a user might want to know of it
sphere::Products products_of_size(int size, std::vector<std::string>& remarks);

/// Products for the steps of a flow: by OpenBLAS where the matrices are large enough for it to be loaded, on
/// several threads where they are larger still; and block by block where the flow looks the same after a turn
/// by 1/k of the circle about the pole, which it then does for ever.
///
/// The results do not depend on the number of threads, bit for bit; they do on that of ranks. It is that of
/// the processors, at most 8; the environment variable ACTIO_THREADS says another one.
/// @param absolute  the vorticity at the start, that of the sphere's rotation included
/// @param remarks   what a user might want to know of it
sphere::Products products_of_flow(sphere::SkewHermitian<> const& absolute, std::vector<std::string>& remarks);

}  // namespace actio::scene
