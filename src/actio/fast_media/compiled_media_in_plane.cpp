// The steps of media in the plane that our own programs use most, compiled once.
// In a unit of its own
#include "actio/fast_media/fast_medium_2d.hpp"

namespace actio::media::detail {

template class FusedRows2d<CellOf<FastFluid<PolytropicByRoots<1, 2>>, FastBox2d>>;
template class FusedRows2d<CellOf<FastFluid<PolytropicByRoots<3, 5>>, FastBox2d>>;
template class FusedRows2d<CellOf<FastFluid<PolytropicByRoots<5, 7>>, FastBox2d>>;
template class FusedRows2d<CellOf<FastFluid<PolytropicGas>, FastBox2d>>;
template class FusedRows2d<CellOf<FastNeoHookean<LogarithmicLaw>, FastBox2d>>;
template class FusedRows2d<CellOf<FastStVenantKirchhoff, FastBox2d>>;
template std::array<Plane<Dual<double>>, 4> corner_forces(
    CellOf<FastFluid<PolytropicByRoots<1, 2>>, FastBox2d> const&, Edges<Dual<double>> const&);
template std::array<Plane<Dual<double>>, 4> corner_forces(
    CellOf<FastFluid<PolytropicByRoots<3, 5>>, FastBox2d> const&, Edges<Dual<double>> const&);
template std::array<Plane<Dual<double>>, 4> corner_forces(
    CellOf<FastFluid<PolytropicByRoots<5, 7>>, FastBox2d> const&, Edges<Dual<double>> const&);
template std::array<Plane<Dual<double>>, 4> corner_forces(CellOf<FastFluid<PolytropicGas>, FastBox2d> const&,
                                                          Edges<Dual<double>> const&);
template std::array<Plane<Dual<double>>, 4> corner_forces(
    CellOf<FastNeoHookean<LogarithmicLaw>, FastBox2d> const&, Edges<Dual<double>> const&);
template std::array<Plane<Dual<double>>, 4> corner_forces(CellOf<FastStVenantKirchhoff, FastBox2d> const&,
                                                          Edges<Dual<double>> const&);

}  // namespace actio::media::detail
