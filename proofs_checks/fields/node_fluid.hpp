// An incompressible fluid in the plane that is made of nodes with masses and of triangles between them, whose
// areas are held: what is left of relabellings on a mesh of labels.
//
// A relabelling acts on the labels alone: it replaces a function of the nodes, such as a coordinate of their
// places, by a linear image of it, x -> Bx and y -> By, as composition with a map of labels does.
#pragma once

#include <array>
#include <vector>

#include "actio/linear_algebra/linear.hpp"
#include "actio/linear_algebra/rank.hpp"
#include "models/models.hpp"

namespace actio::checks {

/// Nodes with masses, and triangles.
template <class S>
struct NodeFluid {
  Vector<S> mass;
  std::vector<std::array<int, 3>> cells;

  int nodes() const { return static_cast<int>(mass.size()); }
  /// The area of a cell as a bilinear form in the coordinates of the nodes: x^T A y, A skew.
  Matrix<S> area(std::array<int, 3> const& cell) const {
    Matrix<S> form = Matrix<S>::Zero(nodes(), nodes());
    for (int k = 0; k < 3; ++k) {
      int const p = cell[k], q = cell[(k + 1) % 3];
      form(p, q) += ratio<S>(1, 2), form(q, p) -= ratio<S>(1, 2);
    }
    return form;
  }
  /// The dimension of the algebra of relabellings that leave the kinetic energy and the area of each cell as
  /// they are, for all places of the nodes: B^T M + M B = 0 and B^T A + A B = 0.
  int symmetries() const {
    int const n = nodes();
    std::vector<Matrix<S>> forms = {Matrix<S>(mass.asDiagonal())};
    for (auto const& cell : cells) forms.push_back(area(cell));
    Matrix<S> equations(static_cast<int>(forms.size()) * n * n, n * n);
    for (int c = 0; c < n * n; ++c) {
      Matrix<S> b = Matrix<S>::Zero(n, n);
      b(c / n, c % n) = S(1);
      for (int f = 0; f < static_cast<int>(forms.size()); ++f) {
        Matrix<S> const change = b.transpose() * forms[f] + forms[f] * b;
        for (int r = 0; r < n * n; ++r) equations(f * n * n + r, c) = change(r / n, r % n);
      }
    }
    return n * n - matrix_rank(equations);
  }
};

/// Places and velocities of the nodes, in rows x and y.
template <class S>
struct NodeMotion {
  Matrix<S> place, velocity;
};

/// The rates of the areas, one row a cell, as linear functions of the velocities (x first, then y).
template <class S>
Matrix<S> rates_of_areas(NodeFluid<S> const& fluid, Matrix<S> const& place) {
  int const n = fluid.nodes();
  Matrix<S> rates(static_cast<int>(fluid.cells.size()), 2 * n);
  for (int c = 0; c < static_cast<int>(fluid.cells.size()); ++c) {
    Matrix<S> const a = fluid.area(fluid.cells[c]);
    rates.row(c) << (a * place.row(1).transpose()).transpose(), place.row(0) * a;
  }
  return rates;
}
/// The masses of the coordinates, inverted.
template <class S>
Matrix<S> inverse_masses(NodeFluid<S> const& fluid) {
  Vector<S> inverse(2 * fluid.nodes());
  for (int p = 0; p < fluid.nodes(); ++p) inverse[p] = inverse[fluid.nodes() + p] = S(1) / fluid.mass[p];
  return inverse.asDiagonal();
}
/// Rows x and y as one column, and back.
template <class S>
Vector<S> stacked(Matrix<S> const& rows) {
  Vector<S> column(2 * rows.cols());
  column << rows.row(0).transpose(), rows.row(1).transpose();
  return column;
}
template <class S>
Matrix<S> in_rows(Vector<S> const& column) {
  auto const n = column.size() / 2;
  Matrix<S> rows(2, n);
  rows << column.head(n).transpose(), column.tail(n).transpose();
  return rows;
}
/// The part of a velocity that keeps all areas.
template <class S>
Matrix<S> keeping_areas(NodeFluid<S> const& fluid, Matrix<S> const& place, Matrix<S> const& velocity) {
  Matrix<S> const G = rates_of_areas(fluid, place), back = inverse_masses(fluid) * G.transpose();
  Vector<S> const v = stacked(velocity);
  return in_rows(Vector<S>(v - back * solve_linear(Matrix<S>(G * back), Vector<S>(G * v))));
}
/// The accelerations under the pressures that hold the areas.
template <class S>
Matrix<S> accelerations(NodeFluid<S> const& fluid, NodeMotion<S> const& m) {
  Matrix<S> const G = rates_of_areas(fluid, m.place), back = inverse_masses(fluid) * G.transpose();
  Vector<S> bend(G.rows());
  for (int c = 0; c < bend.size(); ++c)
    bend[c] = S(2) * (m.velocity.row(0) * fluid.area(fluid.cells[c]) * m.velocity.row(1).transpose())(0, 0);
  return in_rows(Vector<S>(-(back * solve_linear(Matrix<S>(G * back), bend))));
}
/// The circulation of one field along a closed line of nodes: means along edges on their chords.
template <class S>
S circulation_along(Matrix<S> const& field, Matrix<S> const& place, std::vector<int> const& loop) {
  S sum(0);
  for (std::size_t k = 0; k < loop.size(); ++k) {
    int const p = loop[k], q = loop[(k + 1) % loop.size()];
    sum += (field.col(p) + field.col(q)).dot(place.col(q) - place.col(p)) / S(2);
  }
  return sum;
}
/// The rate of the circulation of the velocity along nodes that are carried by it: that of the accelerations,
/// since the chords change by differences of velocities, which give the differences of squares.
template <class S>
S rate_of_circulation(NodeFluid<S> const& fluid, NodeMotion<S> const& m, std::vector<int> const& loop) {
  return circulation_along(accelerations(fluid, m), m.place, loop) +
         circulation_along(m.velocity, m.velocity, loop);
}

}  // namespace actio::checks
