// The steps of averaged flow, compiled once.
// In a unit of its own
#include "actio/vorticity/averaged_steps.hpp"

namespace actio::sphere {

template class VorticityStep<AveragedStream>;
template class FastVorticityStep<AveragedStream>;

}  // namespace actio::sphere
