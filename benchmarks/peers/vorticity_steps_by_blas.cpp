// The plain step of the fluid with the products of a BLAS, in a unit of its own: to compile it takes as much
// memory as the rest of the benchmark.
#include "actio/vorticity/blas_products.hpp"
#include "actio/vorticity/vorticity_step.hpp"

namespace actio {

template class VorticityStep<SphereLaplacian, BlasProducts>;

}  // namespace actio
