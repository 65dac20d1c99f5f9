#include "program/systems/sphere/products.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <thread>

#include "actio/skew_matrices/bracket_blocks.hpp"
#include "program/base/blas_library.hpp"
#include "program/base/ranks.hpp"
#include "program/systems/sphere/products_on_ranks.hpp"

namespace actio::scene {
namespace {

/// Below this OpenBLAS is not loaded: the whole run would hardly take longer than that does.
constexpr int smallest_for_blas = 48;
/// Below this a product is not shared between threads.
constexpr int smallest_for_threads = 192;

int threads_for(int n) {
  if (n < smallest_for_threads) return 1;
  if (char const* const said = std::getenv("ACTIO_THREADS"))
    if (int const number = std::atoi(said); number > 0) return std::min(number, 64);
  return std::clamp(static_cast<int>(std::thread::hardware_concurrency()), 1, 8);
}

}  // namespace

sphere::Products products_of_size(int size, std::vector<std::string>& remarks) {
  if (on_several_ranks()) {
    remarks.push_back(
        fmt::format("matrices are multiplied by {} ranks, and rank 0 has them; digits depend on the "
                    "number of ranks as on rounding",
                    shared_ranks()->size()));
    return products_on_ranks();
  }
  if (size >= smallest_for_blas)
    if (sphere::Products const by_blas = blas_products(threads_for(size), remarks)) return by_blas;
  return sphere::eigen_products();
}

sphere::Products products_of_flow(sphere::SkewHermitian<> const& absolute,
                                  std::vector<std::string>& remarks) {
  int const n = static_cast<int>(absolute.size()), fold = sphere::symmetry_of(absolute);
  int const size = fold > 1 ? (n + fold - 1) / fold : n;
  sphere::Products products = products_of_size(size, remarks);
  if (fold <= 1) return products;
  remarks.push_back(
      fmt::format("the flow looks the same after 1/{} of a turn about the pole: matrices are "
                  "multiplied in {} blocks of the size {}",
                  fold, fold, size));
  return std::make_shared<sphere::SymmetricProducts>(fold, products);
}

}  // namespace actio::scene
