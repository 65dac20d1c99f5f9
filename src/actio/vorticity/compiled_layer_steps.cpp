// The step of a layer of fluid, compiled once.
// In a unit of its own
#include "actio/quantized_sphere/helmholtz_stream.hpp"
#include "actio/vorticity/vorticity_step.hpp"

namespace actio::sphere {

template class VorticityStep<HelmholtzStream>;

}  // namespace actio::sphere
