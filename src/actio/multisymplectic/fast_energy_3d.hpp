// What a hexahedral cell of a medium stores, from its edges.
#pragma once

#include "actio/multisymplectic/fast_cell_3d.hpp"

namespace actio::detail {

/// W in space, from the columns of F and J.
template <class Volume, class T>
T stored_energy(FastFluid<Volume> const& medium, Space<T> const&, Space<T> const&, Space<T> const&,
                T const& J) {
  return medium.volume.energy(J);
}
template <class Volume, class T>
T stored_energy(FastNeoHookean<Volume> const& medium, Space<T> const& a, Space<T> const& b, Space<T> const& c,
                T const& J) {
  return medium.mu / 2 * (dot(a, a) + dot(b, b) + dot(c, c) - 3.0) + medium.volume.energy(J);
}
template <class T>
T stored_energy(FastStVenantKirchhoff const& medium, Space<T> const& a, Space<T> const& b, Space<T> const& c,
                T const&) {
  T const e[3] = {0.5 * (dot(a, a) - 1.0), 0.5 * (dot(b, b) - 1.0), 0.5 * (dot(c, c) - 1.0)};
  T const f[3] = {0.5 * dot(b, c), 0.5 * dot(a, c), 0.5 * dot(a, b)};
  T const trace = e[0] + e[1] + e[2];
  return medium.lambda / 2 * (trace * trace) + medium.mu * (e[0] * e[0] + e[1] * e[1] + e[2] * e[2] +
                                                            2.0 * (f[0] * f[0] + f[1] * f[1] + f[2] * f[2]));
}

/// The energy of a cell per mass density: \f$\tfrac{h_1h_2h_3}8\sum W\f$.
template <class Medium, class T>
T cell_energy(Medium const& medium, std::array<double, 3> const& h, Edges3d<T> const& e) {
  Volumes3d<T> const c = volumes_of(e);
  double const all = h[0] * h[1] * h[2];
  T sum(0.0);
  auto const column = [](Space<T> const& a, double length) {
    return Space<T>{a.x / length, a.y / length, a.z / length};
  };
  for (int k = 0; k < 8; ++k)
    sum = sum + stored_energy(medium, column(e.first[k >> 1], h[0]),
                              column(e.second[(k & 1) + 2 * (k >> 2)], h[1]), column(e.third[k & 3], h[2]),
                              T(c.volume[k] / all));
  return all / 8 * sum;
}

}  // namespace actio::detail
