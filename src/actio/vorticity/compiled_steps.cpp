// The step of the fluid on the sphere, compiled once for the command, the programs of the book and the tests.
#include "actio/vorticity/vorticity_step.hpp"

namespace actio {

template class VorticityStep<SphereLaplacian>;

}  // namespace actio
