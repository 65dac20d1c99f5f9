// Products of the matrices of a flow by all ranks of a run.
#pragma once

#include "actio/parallel/parts_on_ranks.hpp"
#include "actio/skew_matrices/products.hpp"

namespace actio::scene {

/// How rank 0 names them to the others.
inline constexpr char const* name_of_products = "products";

/// On rank 0, of several.
/// @throws FileError  where ScaLAPACK cannot be loaded
sphere::Products products_on_ranks();
/// What another rank does for them.
/// @throws FileError  where ScaLAPACK cannot be loaded
std::unique_ptr<RankPart> part_of_products();

}  // namespace actio::scene
