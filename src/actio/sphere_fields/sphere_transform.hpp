// Functions on the sphere as numbers on a grid, and back, in O(N^2) memory.
//
// On the parallel of the colatitude theta a function is a sum over m of e^{im phi} times
// F_m(theta) = sum_l f_lm P_lm(theta): the longitudes are Fourier transforms, the sums over l are made with
// columns of the normalised Legendre functions (legendre_functions.hpp). P_lm(pi - theta) = (-1)^{l-m}
// P_lm(theta) gives two parallels for one.
//
// libsharp of Debian does the same in a quarter of the time, by instructions that it chooses when it runs. It
// is not used: its licence, the GPL, would become that of every program with this library, and at N = 512 a
// transform takes as long as two or three products of matrices, many of which a step has.
#pragma once

#include <unsupported/Eigen/FFT>
#include <vector>

#include "actio/quantized_sphere/matrix_harmonics.hpp"
#include "actio/sphere_fields/legendre_functions.hpp"
#include "actio/sphere_fields/sphere_grid.hpp"

namespace actio::sphere {

/// Calls `use(m, first, lanes, from, u)` for blocks that hold the northern half of the parallels, the equator
/// with it; rows of u before `from` are nothing.
template <class Use>
void over_half_of_sphere(SphereGrid const& grid, int degrees, Use const& use) {
  int const half = (grid.latitudes() + 1) / 2;
  LegendreFunctions functions(grid.colatitude.head(half), degrees);
  LegendreFunctions::Block u;
  for (; functions.m() < degrees; functions.next())
    for (int first = 0; first < half; first += LegendreFunctions::lanes) {
      int const from = functions.block(first, u);
      use(functions.m(), first, std::min(LegendreFunctions::lanes, half - first), from, u);
    }
}

/// The values of functions on a grid, all of the same degrees. O(N^3) operations, O(N^2) memory for each.
///
/// Accuracy: about 1e-13 of the largest value at N = 2048. The grid may be coarser than the functions.
std::vector<GridField> values_on(SphereGrid const& grid, std::vector<SphereHarmonics> const& functions);
/// The same of one.
///
/// \snippet sphere.cpp values_on
inline GridField values_on(SphereGrid const& grid, SphereHarmonics const& f) {
  return std::move(values_on(grid, std::vector{f}).front());
}

/// The coefficients of a function of the degrees below `degrees`, from its values: the inverse of
/// `values_on`.
/// @throws OutsideDomain  where the grid is not Gauss's, or is too coarse for the degrees
SphereHarmonics harmonics_from(SphereGrid const& grid, GridField const& field, int degrees);

}  // namespace actio::sphere
