// What a cell of the optimised implementation has stored: from its edges over any scalar, and from those of
// the displacement, which lose nothing of small strains. In the plane and in space.
#pragma once

#include "actio/stored_energy/fast_cell_3d.hpp"
#include "actio/stored_energy/strain_energies.hpp"

namespace actio::media::detail {

/// The edges that meet at a corner, over the lengths of the cell: F, or of a displacement H.
template <class T>
Matrix<T, 2, 2> corner_gradient(std::array<double, 2> const& h, Edges<T> const& e, int corner) {
  Plane<T> const &a = corner / 2 ? e.above : e.below, &b = corner % 2 ? e.right : e.left;
  Matrix<T, 2, 2> out;
  out(0, 0) = a.x / h[0], out(1, 0) = a.y / h[0], out(0, 1) = b.x / h[1], out(1, 1) = b.y / h[1];
  return out;
}
/// \copydoc corner_gradient
template <class T>
Matrix<T, 3, 3> corner_gradient(std::array<double, 3> const& h, Edges3d<T> const& e, int corner) {
  Space<T> const columns[3] = {e.first[corner >> 1], e.second[(corner & 1) + 2 * (corner >> 2)],
                               e.third[corner & 3]};
  Matrix<T, 3, 3> out;
  for (int k = 0; k < 3; ++k)
    out(0, k) = columns[k].x / h[k], out(1, k) = columns[k].y / h[k], out(2, k) = columns[k].z / h[k];
  return out;
}
/// The sum over the corners of `energy(gradient)`, each with its part of the cell.
template <std::size_t d, class Edges, class Energy>
auto sum_over_corners(std::array<double, d> const& h, Edges const& e, Energy const& energy) {
  auto sum = energy(corner_gradient(h, e, 0));
  for (int k = 1; k < 1 << d; ++k) sum = sum + energy(corner_gradient(h, e, k));
  double part = 1;
  for (double const one : h) part *= one / 2;
  return decltype(sum)(sum * part);
}

/// The energy of a cell per mass density, from its edges.
template <class Medium, std::size_t d, class Edges>
auto cell_energy(Medium const& medium, std::array<double, d> const& h, Edges const& e) {
  return sum_over_corners(h, e, [&](auto const& F) { return energy_of(medium, F); });
}
/// The same from the differences of displacements along its edges.
template <class Medium, std::size_t d, class Edges>
double cell_energy_of_displacement(Medium const& medium, std::array<double, d> const& h, Edges const& e) {
  return sum_over_corners(h, e, [&](auto const& H) { return energy_from(medium, H); });
}

}  // namespace actio::media::detail
