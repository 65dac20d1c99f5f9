// A medium in space, stepped by the optimised implementation: the explicit multisymplectic scheme with eight
// corners a cell.
//
//     FastBox3d const box{{64, 64, 64}, {0.01, 0.01, 0.01}};               // free sides
//     FastMedium3d medium(neo_hookean(1, 1), box, 0.002, 1000, placement, velocity);
//     medium.step(1000);
//     auto const x = medium.places();                                      // plane by plane, row by row
//
// The discrete Lagrangian is that of fast_medium_2d.hpp, with E = (vol/8) sum over corners of W(F).
#pragma once

#include "actio/fast_media/fast_medium.hpp"
#include "actio/fast_media/fast_planes_3d.hpp"

namespace actio::media {

namespace detail {
template <class Cell>
struct FusedNodes<FastBox3d, Cell> {
  using type = FusedPlanes3d<Cell>;
};
}  // namespace detail

/// A medium on a box of hexahedral cells: \ref FastMedium in space, with its constructor
/// `FastMedium3d(medium, box, dt, density, placement, velocity, options)`. The type of the medium is deduced.
///
/// Arguments and errors are those of \ref FastMedium2d, with a \ref FastBox3d, points of three numbers and
/// the density as mass per volume of the body.
///
/// \snippet media.cpp fast_medium_3d
template <class Medium>
using FastMedium3d = FastMedium<Medium, FastBox3d>;

// Our own programs have the steps of these media compiled once (compiled_media_in_space.cpp): that takes
// longer than most of them.
namespace detail {
extern template class FusedPlanes3d<CellOf<FastFluid<PolytropicByRoots<1, 2>>, FastBox3d>>;
extern template class FusedPlanes3d<CellOf<FastNeoHookean<LogarithmicLaw>, FastBox3d>>;
extern template class FusedPlanes3d<CellOf<FastStVenantKirchhoff, FastBox3d>>;
extern template std::array<Space<Dual<double>>, 8> corner_forces(
    CellOf<FastFluid<PolytropicByRoots<1, 2>>, FastBox3d> const&, Edges3d<Dual<double>> const&);
extern template std::array<Space<Dual<double>>, 8> corner_forces(
    CellOf<FastNeoHookean<LogarithmicLaw>, FastBox3d> const&, Edges3d<Dual<double>> const&);
extern template std::array<Space<Dual<double>>, 8> corner_forces(
    CellOf<FastStVenantKirchhoff, FastBox3d> const&, Edges3d<Dual<double>> const&);
}  // namespace detail

}  // namespace actio::media
