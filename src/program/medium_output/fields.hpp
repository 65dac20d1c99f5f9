// Fields of a medium at one time, on cells and nodes.
#pragma once

#include "program/medium_output/field.hpp"

namespace actio::scene {

/// `visit(point, cell)` for each point of each cell.
/// @param density  whether the density is wanted
template <int d, class Visit>
void for_points(MediumView<d> const& medium, std::vector<typename MediumCells<d>::Place> const& x,
                bool density, Visit const& visit) {
  MediumCells<d> const& cells = medium.motion->cells();
  std::array<double, d> at[8], from[8], moved[8];
  for (std::size_t c = 0; c < cells.cells(); ++c) {
    auto const cell = cells.cell(c);
    cells.gather(cell, x, at), cells.gather_reference(cell, from), cells.gather_displacement(cell, x, moved);
    auto const correction = cells.correction(from);
    Matrix<double, d, d> const more = cells.common(correction, at),
                               more_moved = cells.common(correction, moved);
    for (int p = 0; p < cells.points(); ++p) {
      PointOfCell<d> point{c, p, 0, 1, 1, {}, {}, {}, 0, &correction};
      auto const edges = cells.edges(from, p);
      point.volume = media::small_determinant(edges) * cells.share() * correction.ratio;
      point.inverse = inverse_matrix(edges);
      point.F = cells.edges(at, p) * point.inverse + more;
      point.H = cells.edges(moved, p) * point.inverse + more_moved;
      point.jacobian = media::small_determinant(point.F);
      if (density) {
        std::array<double, d> X = from[p];
        if (cells.points() == 1) {
          int const corners = media::corner_count(cells.shape());
          X = {};
          for (int b = 0; b < corners; ++b)
            for (int a = 0; a < d; ++a) X[a] += from[b][a] / corners;
        }
        point.density = medium.density(X), point.weight = medium.law->weight(point.density);
      }
      visit(point, cell);
    }
  }
}

/// Writes fields at a point, one after the other.
template <int d>
void write_fields(MediumView<d> const& medium, PointOfCell<d> const& point, MediumFields<d> const& asked,
                  double* out) {
  PointOfMedium<d> at{*medium.law, point, Matrix<double, d, d>::Zero()};
  if (std::ranges::any_of(asked, &MediumField<d>::needs_stress))
    at.stress = medium.law->stress_beyond(point.H) * point.F.transpose() * (point.weight / point.jacobian) -
                Matrix<double, d, d>::Identity() * point.multiplier;
  for (auto const& field : asked) field.write(at, out), out += field.width();
}

/// Means of the fields over cells or around nodes, weighed by reference volume; one after the other for each.
/// @param multipliers  of the cells where their volumes are kept, at the time of the places; otherwise none
template <int d>
std::vector<double> mean_fields(MediumView<d> const& medium,
                                std::vector<typename MediumCells<d>::Place> const& x,
                                std::vector<double> const& multipliers, MediumFields<d> const& asked,
                                bool on_nodes) {
  std::size_t const size = field_size(asked);
  MediumCells<d> const& cells = medium.motion->cells();
  std::size_t const count = on_nodes ? cells.nodes() : cells.cells();
  std::vector<double> sums(count * size, 0), volumes(size > 0 ? count : 0, 0), here(size);
  if (size == 0) return sums;
  auto const add = [&](std::size_t to, double share) {
    volumes[to] += share;
    for (std::size_t k = 0; k < size; ++k) sums[to * size + k] += share * here[k];
  };
  bool const many = cells.points() > 1;
  int const corners = media::corner_count(cells.shape());
  for_points(medium, x, true, [&](PointOfCell<d> point, auto const& cell) {
    if (!multipliers.empty()) point.multiplier = multipliers[point.cell];
    write_fields(medium, point, asked, here.data());
    if (!on_nodes)
      add(point.cell, point.volume);
    else if (many)
      add(static_cast<std::size_t>(cell.nodes[static_cast<std::size_t>(point.point)]), point.volume);
    else
      for (int b = 0; b < corners; ++b)
        add(static_cast<std::size_t>(cell.nodes[static_cast<std::size_t>(b)]), point.volume / corners);
  });
  for (std::size_t k = 0; k < sums.size(); ++k) sums[k] /= volumes[k / size];
  return sums;
}

/// The largest residual of the balances of momentum and angular momentum over the cells of the last slab:
/// what the discrete Noether currents of translations and turns add up to over a cell, over the largest sum
/// of their moduli. Zero but for rounding.
/// @param step  of time
template <int d>
double noether_residual(MediumView<d> const& medium, std::vector<typename MediumCells<d>::Place> const& x,
                        std::vector<typename MediumCells<d>::Place> const& v, double step) {
  struct Sums {
    double force[3] = {}, torque[3] = {}, modulus = 0, moment = 0;
  };
  double residual[2] = {}, modulus[2] = {};
  Sums sums;
  std::size_t of = 0;
  auto const close = [&] {
    for (int a = 0; a < 3; ++a) {
      residual[0] = std::max(residual[0], std::abs(sums.force[a]));
      residual[1] = std::max(residual[1], std::abs(sums.torque[a]));
    }
    modulus[0] = std::max(modulus[0], sums.modulus), modulus[1] = std::max(modulus[1], sums.moment);
    sums = {};
  };
  MediumCells<d> const& cells = medium.motion->cells();
  auto const add = [&](std::array<double, d> const& place, double const* force, double momentum) {
    double at[3] = {}, f[3] = {}, size = 0, length = 0;
    for (int a = 0; a < d; ++a)
      at[a] = place[a], f[a] = force[a], size += f[a] * f[a], length += at[a] * at[a];
    for (int a = 0; a < 3; ++a) {
      int const b = (a + 1) % 3, c = (a + 2) % 3;
      sums.force[a] += f[a], sums.torque[a] += at[b] * f[c] - at[c] * f[b];
    }
    double const both = std::sqrt(size) + momentum;
    sums.modulus += both, sums.moment += std::sqrt(length) * both;
  };
  for_points(medium, x, true, [&](PointOfCell<d> const& point, auto const& cell) {
    if (point.cell != of) close(), of = point.cell;
    std::array<double, d> at[8];
    cells.gather(cell, x, at);
    Matrix<double, d, d> const P = medium.law->stress_beyond(point.H) * (point.weight * point.volume * step);
    for (int k = 0; k < d; ++k) {
      auto const [low, up] = cells.ends(point.point, k);
      double pull[3] = {}, push[3] = {}, speed = 0;
      for (int i = 0; i < d; ++i) {
        for (int j = 0; j < d; ++j) pull[i] += P(i, j) * point.inverse(k, j);
        push[i] = -pull[i];
        double const one = v[static_cast<std::size_t>(cell.nodes[static_cast<std::size_t>(low)])][i];
        speed += one * one;
      }
      double const momentum = 2 * point.density * point.volume * std::sqrt(speed) / d;
      add(at[low], pull, momentum), add(at[up], push, momentum);
    }
    double on[8][d] = {};
    point.correction->add_forces(P, on);
    for (int b = 0; point.correction->any && b < 1 << d; ++b) add(at[b], on[b], 0);
  });
  close();
  double worst = 0;
  for (int k = 0; k < 2; ++k)
    if (modulus[k] > 0) worst = std::max(worst, residual[k] / modulus[k]);
  return worst;
}

}  // namespace actio::scene
