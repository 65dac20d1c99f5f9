// The fast step of the fluid with the products of a BLAS, in a unit of its own.
#include "actio/vorticity/blas_products.hpp"
#include "actio/vorticity/fast_vorticity_step.hpp"

namespace actio {

template class FastVorticityStep<SphereLaplacian, BlasProducts>;

}  // namespace actio
