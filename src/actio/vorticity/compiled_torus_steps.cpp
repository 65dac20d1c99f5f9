// The steps of a flow on the torus, compiled once.
// In a unit of its own
#include "actio/vorticity/torus_steps.hpp"

namespace actio::sphere {

template class VorticityStep<torus::TorusStream>;
template class FastVorticityStep<torus::TorusStream>;

}  // namespace actio::sphere
