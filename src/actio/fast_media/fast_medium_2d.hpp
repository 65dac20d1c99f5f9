// A medium in the plane, stepped by the optimised implementation: the explicit multisymplectic scheme, fused.
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

/// A medium on a rectangle of cells: \ref FastMedium in the plane, with its constructor
/// `FastMedium2d(medium, box, dt, density, placement, velocity, options)`. The type of the medium is deduced.
///
/// | argument | what it is |
/// |---|---|
/// | `medium` | stored energy per unit mass, speed squared: see below |
/// | `box` | cells, their lengths and what the sides do: \ref FastBox2d |
/// | `dt` | time step, time; positive |
/// | `density` | mass per area of the body; positive |
/// | `placement` | callable: a point of the body, two numbers, to its position at the start, length |
/// | `velocity` | callable: the point to its velocity at the start, length/time |
/// | `options` | threads and steps in one pass, \ref FastOptions; may be left out |
///
/// The medium is made by \ref neo_hookean or \ref blatz_ko, or is a \ref FastStVenantKirchhoff or a
/// \ref FastFluid.
///
/// It throws OutsideDomain or NotFinite where the box, `dt` or `density` is none, or `dt` is longer than the
/// longest stable step, which the message tells; and \ref CellInverts where a cell is inside out at the
/// start.
///
/// \snippet media.cpp fast_medium_2d
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
