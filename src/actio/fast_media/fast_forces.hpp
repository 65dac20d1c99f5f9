// The forces on the nodes of a medium, all at once and by a plain loop over the cells: what the fused steps
// do not need, for the first half step, for velocities at the time of a node, and over dual numbers for the
// largest frequency. In the plane and in space.
#pragma once

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include "actio/fast_media/fast_box_2d.hpp"
#include "actio/fast_media/fast_box_3d.hpp"
#include "actio/multisymplectic/largest_frequency.hpp"
#include "actio/numbers/dual.hpp"

namespace actio::media::detail {

/// A vector of the space that a box lies in.
template <class Box, class T>
using VectorOf = std::conditional_t<Box::dimension == 2, Plane<T>, Space<T>>;

/// Component c.
template <class T>
T& component(Plane<T>& a, int c) { return c == 0 ? a.x : a.y; }
/// \copydoc component
template <class T>
T& component(Space<T>& a, int c) { return c == 0 ? a.x : c == 1 ? a.y : a.z; }

/// Calls `visit(index)` for all indices below n, the first one fastest.
template <std::size_t d, class Visit>
void for_indices(std::array<int, d> const& n, Visit const& visit) {
  std::array<int, d> index{};
  while (true) {
    visit(index);
    std::size_t i = 0;
    while (i < d && ++index[i] == n[i]) index[i++] = 0;
    if (i == d) return;
  }
}
/// Calls `visit(node, k)` for all nodes, number k in their order.
template <class Box, class Visit>
void for_nodes(Box const& box, Visit const& visit) {
  std::array<int, Box::dimension> n;
  for (int d = 0; d < Box::dimension; ++d) n[d] = box.nodes(d);
  std::size_t k = 0;
  for_indices(n, [&](auto const& node) { visit(node, k++); });
}

/// The corners of a cell among the nodes, and along which directions each is a period away.
template <int n>
struct CellCorners {
  std::array<std::size_t, 1 << n> node;
  std::array<int, 1 << n> periods;  ///< bit d: along direction d
};
template <class Box>
CellCorners<Box::dimension> corners_of(Box const& box, std::array<int, Box::dimension> const& cell) {
  CellCorners<Box::dimension> out{};
  for (int k = 0; k < 1 << Box::dimension; ++k) {
    auto const to = static_cast<std::size_t>(k);
    for (int d = Box::dimension - 1; d >= 0; --d) {
      int const i = cell[d] + (k >> d & 1), n = box.nodes(d);
      if (i == n) out.periods[to] |= 1 << d;
      out.node[to] = out.node[to] * static_cast<std::size_t>(n) + static_cast<std::size_t>(i % n);
    }
  }
  return out;
}
/// The edges of a cell.
/// @param displacements  whether x are those: a corner beyond a seam is moved by its period without the
///   length of that
template <class Box, class T, template <class> class Vector>
auto edges_of(Box const& box, CellCorners<Box::dimension> const& c, std::vector<Vector<T>> const& x,
              bool displacements = false) {
  Vector<T> p[1 << Box::dimension];
  for (std::size_t k = 0; k < c.node.size(); ++k) {
    p[k] = x[c.node[k]];
    for (int d = 0; d < Box::dimension; ++d) {
      if (!(c.periods[k] >> d & 1)) continue;
      auto shift = box.shift(d);
      if (displacements) component(shift, d) -= box.cells[d] * box.spacing[d];
      for (int i = 0; i < Box::dimension; ++i) component(p[k], i) = component(p[k], i) + component(shift, i);
    }
  }
  return edges_between(p);
}

/// The accelerations of all nodes at places x: force per mass density times the response of the node.
template <class Box, class Cell, class T, template <class> class Vector>
std::vector<Vector<T>> accelerations(Box const& box, Cell const& cell, std::vector<Vector<T>> const& x) {
  std::vector<Vector<T>> f(x.size(), Vector<T>{});
  for_indices(box.cells, [&](auto const& index) {
    auto const c = corners_of(box, index);
    auto const forces = corner_forces(cell, edges_of(box, c, x));
    for (std::size_t k = 0; k < c.node.size(); ++k) f[c.node[k]] = f[c.node[k]] + forces[k];
  });
  for_nodes(box, [&](auto const& node, std::size_t k) {
    for (int i = 0; i < Box::dimension; ++i) component(f[k], i) = component(f[k], i) * box.response(node, i);
  });
  return f;
}

/// The largest frequency of small motions about places x, per time, of the linearised accelerations by dual
/// numbers: from below, within half a per cent (\ref largest_frequency of one callable).
///
/// Cost: some thirty forces on all nodes.
template <class Box, class Cell, template <class> class Vector>
double largest_frequency(Box const& box, Cell const& cell, std::vector<Vector<double>> const& x) {
  constexpr std::size_t d = Box::dimension;
  std::vector<double> mass(d * x.size(), 0), start(d * x.size(), 0);
  // The fastest motions set neighbours against each other; beside those, some of every motion.
  std::minstd_rand random(1);
  auto const some = [&random] { return static_cast<double>(random()) / std::minstd_rand::max() - 0.5; };
  for_nodes(box, [&](auto const& node, std::size_t k) {
    for (std::size_t i = 0; i < d; ++i) {
      double others = 1;
      for (std::size_t a = 0; a < d; ++a)
        if (a != i) others += node[a] % 2 ? -1 : 1;
      double const motion = (node[i] % 2 ? -1 : 1) * others + some();
      double const response = box.response(node, static_cast<int>(i));
      if (response > 0) mass[d * k + i] = 1 / response, start[d * k + i] = motion;
    }
  });
  std::vector<Vector<Dual<double>>> moved(x.size());
  return largest_frequency([&](std::size_t k) { return mass[k]; }, std::move(start),
                           [&](std::vector<double> const& u, std::vector<double>& out) {
                             for (std::size_t k = 0; k < x.size(); ++k)
                               for (std::size_t i = 0; i < d; ++i) {
                                 Vector<double> place = x[k];
                                 auto& one = component(moved[k], static_cast<int>(i));
                                 one = Dual<double>(component(place, static_cast<int>(i)));
                                 one.part[0] = u[d * k + i];
                               }
                             auto a = accelerations(box, cell, moved);
                             out.resize(u.size());
                             for (std::size_t k = 0; k < x.size(); ++k)
                               for (std::size_t i = 0; i < d; ++i)
                                 out[d * k + i] = -component(a[k], static_cast<int>(i)).part[0];
                           });
}

/// How strongly a cell resists to be squeezed: the change of its forces on its corners when these go towards
/// each other along all directions, over theirs, one over time squared and per area or volume.
template <class Box, class Cell, template <class> class Vector>
double stiffness_of(Box const& box, Cell const& cell, std::array<int, Box::dimension> const& index,
                    std::vector<Vector<double>> const& x) {
  auto const c = corners_of(box, index);
  Vector<Dual<double>> moved[1 << Box::dimension];
  for (std::size_t k = 0; k < c.node.size(); ++k)
    for (int i = 0; i < Box::dimension; ++i) {
      Vector<double> place = x[c.node[k]];
      double at = component(place, i);
      for (int d = 0; d < Box::dimension; ++d) {
        auto shift = box.shift(d);
        if (c.periods[k] >> d & 1) at += component(shift, i);
      }
      component(moved[k], i) = Dual<double>(at);
      component(moved[k], i).part[0] = k >> i & 1 ? -1 : 1;
    }
  auto forces = corner_forces(cell, edges_between(moved));
  double sum = 0;
  for (std::size_t k = 0; k < c.node.size(); ++k)
    for (int i = 0; i < Box::dimension; ++i) sum -= component(forces[k], i).part[0] * (k >> i & 1 ? -1 : 1);
  return sum;
}

/// A bound of the time steps that are stable for small motions about places x, from above: that of the
/// motions of up to eight cells along each direction, around the cell of a sample that resists most, with all
/// other nodes held. Where the medium is alike there, it is within three per cent.
///
/// Cost: that of forces on some ten thousand cells, whatever the box.
template <class Box, class Cell, template <class> class Vector>
double bound_of_stable_steps(Box const& box, Cell const& cell, std::vector<Vector<double>> const& x) {
  constexpr int most = 8, sample = 4096;
  double cells = 1;
  for (int const n : box.cells) cells *= n;
  long const stride = std::max(1L, static_cast<long>(cells / sample) | 1);
  std::array<int, Box::dimension> stiffest{};
  double stiffness = -HUGE_VAL;
  long count = 0;
  for_indices(box.cells, [&](auto const& index) {
    if (count++ % stride != 0) return;
    double const here = stiffness_of(box, cell, index, x);
    if (here > stiffness) stiffness = here, stiffest = index;
  });
  // Where the window ends in the body it is held: what is slower then is no faster without that.
  Box window = box;
  std::array<int, Box::dimension> first{};
  for (int d = 0; d < Box::dimension; ++d) {
    if (box.cells[d] <= most) continue;
    first[d] = std::clamp(stiffest[d] - most / 2, 0, box.nodes(d) - 1 - most);
    window.cells[d] = most;
    auto& ends = window.ends(d);
    if (box.periodic(d) || first[d] > 0) ends[0] = Side::fixed;
    if (box.periodic(d) || first[d] + most < box.cells[d]) ends[1] = Side::fixed;
  }
  std::vector<Vector<double>> inside;
  for_nodes(window, [&](auto node, std::size_t) {
    std::size_t k = 0;
    for (int d = Box::dimension - 1; d >= 0; --d)
      k = k * static_cast<std::size_t>(box.nodes(d)) + static_cast<std::size_t>(node[d] + first[d]);
    inside.push_back(x[k]);
  });
  return 2 / largest_frequency(window, cell, inside);
}

}  // namespace actio::media::detail
