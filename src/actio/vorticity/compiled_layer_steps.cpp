// The step of a layer of fluid, compiled once.
#include "actio/vorticity/helmholtz_stream.hpp"
#include "actio/vorticity/vorticity_step.hpp"

namespace actio {

template class VorticityStep<HelmholtzStream>;

}  // namespace actio
