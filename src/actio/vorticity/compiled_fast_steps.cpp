// The fast step of the fluid on the sphere, compiled once.
#include "actio/vorticity/fast_vorticity_step.hpp"

namespace actio {

template class FastVorticityStep<SphereLaplacian>;

}  // namespace actio
