#include "program/base/blas_library.hpp"

#include <dlfcn.h>

#include <cstdlib>

namespace actio::scene {
namespace {

/// The functions, or why there are none.
struct Blas {
  sphere::BlasFunctions functions;
  std::string why;

  Blas() {
    // Threads of its own would only wait; it starts them when it is loaded.
    ::setenv("OPENBLAS_NUM_THREADS", "1", 0);
    void* const library = ::dlopen(ACTIO_BLAS_LIBRARY, RTLD_NOW | RTLD_LOCAL);
    if (!library) {
      char const* const message = ::dlerror();
      why = message ? message : "it was not found when this command was built";
      return;
    }
    functions = {reinterpret_cast<sphere::Gemm<double>*>(::dlsym(library, "dgemm_")),
                 reinterpret_cast<sphere::Gemm<float>*>(::dlsym(library, "sgemm_"))};
    if (!functions.dgemm || !functions.sgemm) why = ACTIO_BLAS_LIBRARY " has no dgemm_ and sgemm_";
    // Threads are ours: what they share does not depend on how many they are.
    if (auto const set = reinterpret_cast<void (*)(int)>(::dlsym(library, "openblas_set_num_threads")))
      set(1);
  }
};

}  // namespace

sphere::Products blas_products(int threads, std::vector<std::string>& remarks) {
  static Blas const blas;
  if (blas.why.empty()) return std::make_shared<sphere::BlasProducts>(blas.functions, threads);
  remarks.push_back("OpenBLAS cannot be loaded, and products of matrices take longer: " + blas.why);
  return nullptr;
}

}  // namespace actio::scene
