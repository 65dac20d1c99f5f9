// The steps of media in the space that our own programs use most, compiled once.
// In a unit of its own
#include "actio/fast_media/fast_medium_3d.hpp"

namespace actio::media::detail {

template class FusedPlanes3d<CellOf<FastFluid<PolytropicByRoots<1, 2>>, FastBox3d>>;
template class FusedPlanes3d<CellOf<FastNeoHookean<LogarithmicLaw>, FastBox3d>>;
template class FusedPlanes3d<CellOf<FastStVenantKirchhoff, FastBox3d>>;
template std::array<Space<Dual<double>>, 8> corner_forces(
    CellOf<FastFluid<PolytropicByRoots<1, 2>>, FastBox3d> const&, Edges3d<Dual<double>> const&);
template std::array<Space<Dual<double>>, 8> corner_forces(
    CellOf<FastNeoHookean<LogarithmicLaw>, FastBox3d> const&, Edges3d<Dual<double>> const&);
template std::array<Space<Dual<double>>, 8> corner_forces(CellOf<FastStVenantKirchhoff, FastBox3d> const&,
                                                          Edges3d<Dual<double>> const&);

}  // namespace actio::media::detail
