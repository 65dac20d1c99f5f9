// The forces on the nodes of a medium in the plane, all at once and by a plain loop over the cells: what the
// fused steps do not need, for the first half step, for velocities at the time of a node, and over dual
// numbers for the largest frequency.
#pragma once

#include <cmath>
#include <random>
#include <vector>

#include "actio/multisymplectic/fast_box_2d.hpp"
#include "actio/numbers/dual.hpp"

namespace actio::detail {

/// The four corners of a cell among the nodes, row by row, and how many periods each is away.
struct Corners2d {
  std::array<std::size_t, 4> node;
  bool right, above;  ///< whether the right corners, and those above, are a period away
};
inline Corners2d corners_of(FastBox2d const& box, int i, int j) {
  int const n1 = box.nodes(0), n2 = box.nodes(1);
  bool const right = i + 1 == n1, above = j + 1 == n2;
  auto const at = [n1](int a, int b) {
    return static_cast<std::size_t>(b) * static_cast<std::size_t>(n1) + static_cast<std::size_t>(a);
  };
  int const i1 = right ? 0 : i + 1, j1 = above ? 0 : j + 1;
  return {{at(i, j), at(i1, j), at(i, j1), at(i1, j1)}, right, above};
}
/// The edges of a cell.
template <class T>
Edges<T> edges_of(FastBox2d const& box, Corners2d const& c, std::vector<Plane<T>> const& x) {
  Plane<T> p[4] = {x[c.node[0]], x[c.node[1]], x[c.node[2]], x[c.node[3]]};
  for (int k = 0; k < 4; ++k) {
    if (k % 2 && c.right) p[k].x = p[k].x + box.shift(0).x, p[k].y = p[k].y + box.shift(0).y;
    if (k / 2 && c.above) p[k].x = p[k].x + box.shift(1).x, p[k].y = p[k].y + box.shift(1).y;
  }
  return edges_between(p[0], p[1], p[2], p[3]);
}

/// The accelerations of all nodes at places x: force per mass density times the response of the node.
template <class Cell, class T>
std::vector<Plane<T>> accelerations(FastBox2d const& box, Cell const& cell, std::vector<Plane<T>> const& x) {
  std::vector<Plane<T>> f(x.size(), Plane<T>{T(0.0), T(0.0)});
  for (int j = 0; j < box.cells[1]; ++j)
    for (int i = 0; i < box.cells[0]; ++i) {
      Corners2d const c = corners_of(box, i, j);
      Edges<T> const e = edges_of(box, c, x);
      T d[4];
      areas(e, d);
      Edges<T> const s = cell.slopes(e, d);
      f[c.node[0]] = f[c.node[0]] + (s.below + s.left);
      f[c.node[1]] = f[c.node[1]] + (s.right - s.below);
      f[c.node[2]] = f[c.node[2]] + (s.above - s.left);
      f[c.node[3]] = f[c.node[3]] - (s.above + s.right);
    }
  std::size_t k = 0;
  for (int j = 0; j < box.nodes(1); ++j)
    for (int i = 0; i < box.nodes(0); ++i, ++k)
      f[k] = {f[k].x * box.response(i, j, 0), f[k].y * box.response(i, j, 1)};
  return f;
}

/// The largest frequency of small motions about places x, per time: the root of the largest eigenvalue of the
/// linearised accelerations, by powers of it on dual numbers.
///
/// Accuracy: from below, within a per cent; the iteration ends when a round changes it by less than 1e-6 of
/// itself, or after 400 rounds. Cost: a round is a force on all nodes.
template <class Cell>
double largest_frequency(FastBox2d const& box, Cell const& cell, std::vector<Plane<double>> const& x) {
  using T = Dual<double>;
  std::vector<Plane<T>> moved(x.size());
  // The fastest motions set neighbours against each other; beside those, some of every motion.
  std::vector<Plane<double>> u(x.size());
  std::minstd_rand random(1);
  auto const some = [&random] { return static_cast<double>(random()) / std::minstd_rand::max() - 0.5; };
  std::size_t k = 0;
  for (int j = 0; j < box.nodes(1); ++j)
    for (int i = 0; i < box.nodes(0); ++i, ++k) {
      double const across = i % 2 ? -1 : 1, up = j % 2 ? -1 : 1;
      u[k] = {across * (1 + up) + some(), up * (1 + across) + some()};
    }
  double frequency = 0, before = 0;
  for (int round = 0; round < 400; ++round) {
    double size = 0;
    for (auto const& p : u) size += p.x * p.x + p.y * p.y;
    if (!(size > 0) || !std::isfinite(size)) break;
    double const scale = 1 / std::sqrt(size);
    for (k = 0; k < x.size(); ++k) {
      moved[k].x = T(x[k].x), moved[k].y = T(x[k].y);
      moved[k].x.part[0] = scale * u[k].x, moved[k].y.part[0] = scale * u[k].y;
    }
    auto const a = accelerations(box, cell, moved);
    double norm = 0;
    for (k = 0; k < x.size(); ++k) {
      u[k] = {a[k].x.part[0], a[k].y.part[0]};
      norm += u[k].x * u[k].x + u[k].y * u[k].y;
    }
    frequency = std::sqrt(std::sqrt(norm));
    if (round > 60 && std::abs(frequency - before) <= 1e-6 * frequency) break;
    before = frequency;
  }
  return frequency;
}

}  // namespace actio::detail
