#include "program/base/blas_library.hpp"

#include <cstdlib>

#include "program/base/error.hpp"
#include "program/base/module.hpp"

namespace actio::scene {

sphere::Products blas_products(int threads, std::vector<std::string>& remarks) {
  try {
    // Threads of its own would only wait; it starts them when it is loaded.
    ::setenv("OPENBLAS_NUM_THREADS", "1", 0);
    sphere::BlasFunctions functions;
    of_module<void(sphere::BlasFunctions&)>("actio_blas", "actio_blas")(functions);
    return std::make_shared<sphere::BlasProducts>(functions, threads);
  } catch (FileError const& error) {
    remarks.push_back(std::string("OpenBLAS cannot be loaded, and products of matrices take longer: ") +
                      error.what());
    return nullptr;
  }
}

}  // namespace actio::scene
