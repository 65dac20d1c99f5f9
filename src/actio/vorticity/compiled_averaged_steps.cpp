// The steps of averaged flow, compiled once.
// In a unit of its own
#include "actio/quantized_sphere/averaged_stream.hpp"
#include "actio/vorticity/fast_vorticity_step.hpp"

namespace actio::sphere {

template class VorticityStep<AveragedStream>;
template class FastVorticityStep<AveragedStream>;

}  // namespace actio::sphere
