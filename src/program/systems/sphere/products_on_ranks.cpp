#include "program/systems/sphere/products_on_ranks.hpp"

#include <cstdlib>

#include "actio/skew_matrices/products_on_ranks.hpp"
#include "program/base/error.hpp"
#include "program/base/module.hpp"
#include "program/base/ranks.hpp"

namespace actio::scene {
namespace {

sphere::DealtFunctions scalapack() {
  // A rank has one thread, unless its user wants more.
  ::setenv("OPENBLAS_NUM_THREADS", "1", 0);
  sphere::DealtFunctions out;
  try {
    of_module<void(sphere::DealtFunctions&)>("actio_scalapack", "actio_scalapack")(out);
  } catch (FileError const& error) {
    throw FileError("ranks share a flow by the products of ScaLAPACK (Debian: libscalapack-openmpi-dev): " +
                    std::string(error.what()));
  }
  return out;
}

class ProductsPart final : public RankPart {
 public:
  void answer(PartCall const&) override { product_.help(); }

 private:
  sphere::DealtProduct product_{*shared_ranks(), scalapack()};
};

}  // namespace

sphere::Products products_on_ranks() {
  sphere::DealtFunctions const functions = scalapack();
  auto const part = std::make_shared<PartsOnRanks>(shared_ranks(), name_of_products);
  return std::make_shared<sphere::ProductsOnRanks>(*shared_ranks(), functions,
                                                   [part] { auto const asked = part->ask({}); });
}

std::unique_ptr<RankPart> part_of_products() { return std::make_unique<ProductsPart>(); }

}  // namespace actio::scene
