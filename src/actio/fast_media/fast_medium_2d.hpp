// A medium in the plane, stepped by the fast road: the explicit multisymplectic scheme, fused.
//
//     FastBox2d const box{{200, 100}, {0.01, 0.01}};                       // free sides
//     FastMedium2d medium(neo_hookean(1, 1), box, 0.002, 1000, placement, velocity);
//     medium.step(1000);
//     auto const x = medium.places();                                      // of the nodes, row by row
//
// The discrete Lagrangian of a slab of cells between two times is
//
//     L_d = sum over nodes of (m/2)|x1-x0|^2/dt - (dt/2)(E(x0)+E(x1)), E = (vol/4) sum over corners of W(F),
//
// and its Euler-Lagrange field equations are the leapfrog: v += dt a(x), x += dt v, with v half a step back.
#pragma once

#include "actio/fast_media/fast_medium.hpp"
#include "actio/fast_media/fast_rows_2d.hpp"

namespace actio::media {

namespace detail {
template <class Cell>
struct FusedNodes<FastBox2d, Cell> {
  using type = FusedRows2d<Cell>;
};
}  // namespace detail

/// A medium on a rectangle of cells.
template <class Medium>
using FastMedium2d = FastMedium<Medium, FastBox2d>;

// Our own programs have the steps of these media compiled once (compiled_media_in_plane.cpp): that takes
// longer than most of them.
namespace detail {
extern template class FusedRows2d<CellOf<FastFluid<PolytropicByRoots<1, 2>>, FastBox2d>>;
extern template class FusedRows2d<CellOf<FastFluid<PolytropicByRoots<3, 5>>, FastBox2d>>;
extern template class FusedRows2d<CellOf<FastFluid<PolytropicByRoots<5, 7>>, FastBox2d>>;
extern template class FusedRows2d<CellOf<FastFluid<PolytropicGas>, FastBox2d>>;
extern template class FusedRows2d<CellOf<FastNeoHookean<LogarithmicLaw>, FastBox2d>>;
extern template class FusedRows2d<CellOf<FastStVenantKirchhoff, FastBox2d>>;
extern template std::array<Plane<Dual<double>>, 4> corner_forces(
    CellOf<FastFluid<PolytropicByRoots<1, 2>>, FastBox2d> const&, Edges<Dual<double>> const&);
extern template std::array<Plane<Dual<double>>, 4> corner_forces(
    CellOf<FastFluid<PolytropicByRoots<3, 5>>, FastBox2d> const&, Edges<Dual<double>> const&);
extern template std::array<Plane<Dual<double>>, 4> corner_forces(
    CellOf<FastFluid<PolytropicByRoots<5, 7>>, FastBox2d> const&, Edges<Dual<double>> const&);
extern template std::array<Plane<Dual<double>>, 4> corner_forces(
    CellOf<FastFluid<PolytropicGas>, FastBox2d> const&, Edges<Dual<double>> const&);
extern template std::array<Plane<Dual<double>>, 4> corner_forces(
    CellOf<FastNeoHookean<LogarithmicLaw>, FastBox2d> const&, Edges<Dual<double>> const&);
extern template std::array<Plane<Dual<double>>, 4> corner_forces(
    CellOf<FastStVenantKirchhoff, FastBox2d> const&, Edges<Dual<double>> const&);
}  // namespace detail

}  // namespace actio::media
