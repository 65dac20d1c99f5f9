// The fast step of the fluid on the sphere, compiled once.
// In a unit of its own
#include "actio/vorticity/fast_vorticity_step.hpp"

namespace actio::sphere {

template class FastVorticityStep<SphereLaplacian>;

}  // namespace actio::sphere
