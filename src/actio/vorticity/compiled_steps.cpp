// The step of the fluid on the sphere, compiled once for the command, the programs of the book and the tests.
// In a unit of its own
#include "actio/vorticity/vorticity_step.hpp"

namespace actio::sphere {

template class VorticityStep<SphereLaplacian>;

}  // namespace actio::sphere
