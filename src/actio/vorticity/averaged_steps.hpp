// The steps of averaged flow: those of Euler's fluid with another stream function
// (quantized_sphere/averaged_stream.hpp), compiled once.
#pragma once

#include "actio/quantized_sphere/averaged_stream.hpp"
#include "actio/vorticity/fast_vorticity_step.hpp"

namespace actio::sphere {

extern template class VorticityStep<AveragedStream>;
extern template class FastVorticityStep<AveragedStream>;

}  // namespace actio::sphere
