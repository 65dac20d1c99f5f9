// Products of matrices by OpenBLAS.
#include "actio/skew_matrices/blas_products.hpp"

extern "C" {
/// \cond
void dgemm_(char const*, char const*, int const*, int const*, int const*, double const*, double const*,
            int const*, double const*, int const*, double const*, double*, int const*);
void sgemm_(char const*, char const*, int const*, int const*, int const*, float const*, float const*,
            int const*, float const*, int const*, float const*, float*, int const*);
void openblas_set_num_threads(int);
/// \endcond

/// Its functions. Threads are ours: what they share does not depend on how many they are.
void actio_blas(actio::sphere::BlasFunctions& out) {
  openblas_set_num_threads(1);
  out = {&dgemm_, &sgemm_};
}
}
