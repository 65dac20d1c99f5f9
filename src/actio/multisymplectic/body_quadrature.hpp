// Where a cell of a body's mesh has its stored energy: at each corner of box-like cells, once in simplices.
//
// At a corner of a box-like cell d edges meet. With A, their columns in the reference space, and a, those in
// space, \f$F = aA^{-1}\f$: no interpolation, and no motion of a cell is without energy. The corner stands
// for the part \f$\det A/2^d\f$ of the cell. A simplex has one F, from the edges at its first corner.
//
// Where the density of mass varies, corners take their shares of it and of what it makes of the stored energy
// by the hat functions of the cell: \f$\int\rho\,N_b\f$. A gas at rest between walls or against vacuum is
// then as heavy as its pressure is steep, up to the order of the scheme.
#pragma once

#include <functional>

#include "actio/multisymplectic/body_mesh.hpp"
#include "actio/multisymplectic/cell_geometry.hpp"
#include "actio/multisymplectic/stored_energies.hpp"

namespace actio {

/// One deformation gradient of a cell, and what it stands for.
template <int d>
struct CellPoint {
  Matrix<double, d, d> inverse_edges;  ///< \f$A^{-1}\f$, per length
  double volume;                       ///< its part of the reference volume
  double weight;                       ///< of W(F): the integral of the stored energy's weight over this part
};

namespace detail {
/// Points and weights of a cell of some shape, with the hat functions of its corners there.
struct HatQuadrature {
  struct Sample {
    std::array<double, 8> hat{};
    double weight;
  };
  std::vector<Sample> samples;
  std::array<double, 8> total{};  ///< of each hat function
  double all = 0;

  HatQuadrature(BodyMesh::Shape shape, int d) {
    // Gauss and Legendre's three points, on the unit interval; on simplices in collapsed coordinates.
    double const off = std::sqrt(0.15);
    double const at[3] = {0.5 - off, 0.5, 0.5 + off}, of[3] = {5.0 / 18, 8.0 / 18, 5.0 / 18};
    int const count = d == 1 ? 3 : d == 2 ? 9 : 27;
    for (int k = 0; k < count; ++k) {
      int const index[3] = {k % 3, k / 3 % 3, k / 9};
      Sample s{{}, 1};
      double left = 1;  // of the simplex, beyond the coordinates taken
      for (int i = 0; i < d; ++i) s.weight *= of[index[i]];
      if (is_simplex(shape)) {
        for (int i = 0; i < d; ++i) {
          for (int power = i + 1; power < d; ++power) s.weight *= 1 - at[index[i]];
          s.hat[i + 1] = left * at[index[i]], left -= s.hat[i + 1];
        }
        s.hat[0] = left;
      } else {
        for (int b = 0; b < 1 << d; ++b) {
          s.hat[b] = 1;
          for (int i = 0; i < d; ++i) s.hat[b] *= b >> i & 1 ? at[index[i]] : 1 - at[index[i]];
        }
      }
      for (int b = 0; b < 8; ++b) total[b] += s.weight * s.hat[b];
      all += s.weight;
      samples.push_back(s);
    }
  }
};
}  // namespace detail

/// What is known of cells when a program is compiled: simplices with one point, or boxes with one at each
/// corner.
template <int d, bool is_simplex>
struct CellKind {
  static constexpr int corners = is_simplex ? d + 1 : 1 << d;  ///< of a cell
  static constexpr int points = is_simplex ? 1 : 1 << d;       ///< of a cell
  /// The corners at both ends of edge k of a point.
  static constexpr std::array<int, 2> ends(int point, int k) {
    if constexpr (is_simplex)
      return {0, k + 1};
    else
      return {point & ~(1 << k), point | (1 << k)};
  }
};

/// The points of all cells of a mesh, and the masses of its nodes.
template <int d>
class BodyQuadrature {
 public:
  using Place = std::array<double, d>;         ///< a point of the body, or of space
  static constexpr int most_corners = 1 << d;  ///< of a cell of any shape

  /// @param mesh     with cells of dimension d
  /// @param density  mass per reference volume at X; positive inside of the body
  /// @throws NotABodyMesh  where the mesh has another dimension
  /// @throws InvertedCell  where the edges at a corner do not have the orientation of the body
  /// @throws NotFinite, OutsideDomain  where the density is no number, or a cell has no mass
  BodyQuadrature(BodyMesh const& mesh, StoredEnergy<d> const& medium,
                 std::function<double(Place const&)> const& density)
      : corners(corner_count(mesh.shape)), simplex(is_simplex(mesh.shape) || d == 1) {
    if (mesh.dimension != d)
      throw NotABodyMesh("medium on a mesh", "the mesh has the dimension of the medium; dimensions",
                         mesh.dimension, d);
    points_per_cell = simplex ? 1 : corners;
    masses.assign(mesh.nodes.size(), 0);
    points.reserve(mesh.cells.size() * points_per_cell);
    detail::HatQuadrature const hats(mesh.shape, d);
    for (int cell = 0; cell < static_cast<int>(mesh.cells.size()); ++cell)
      add(mesh, cell, hats, medium, density);
    shifts(mesh);
  }

  /// Calls f with the \ref CellKind of the cells, so that loops over corners have a length that is known.
  template <class F>
  auto with_kind(F const& f) const {
    return simplex ? f(CellKind<d, true>{}) : f(CellKind<d, false>{});
  }
  /// Where corners of a cell are, given the places of all nodes.
  /// @param periods  whether a corner beyond a seam is moved by its period: not for velocities
  template <class Kind>
  void gather(Kind, std::vector<double> const& x, int cell, double (*out)[d], bool periods = true) const {
    std::size_t const first = std::size_t(cell) * Kind::corners;
    for (int b = 0; b < Kind::corners; ++b)
      std::copy_n(x.data() + std::size_t(d) * nodes[first + b], d, out[b]);
    if (!periods || wraps.empty()) return;
    for (int b = 0; b < Kind::corners; ++b)
      for (int a = 0; a < d; ++a)
        if (wraps[first + b] >> a & 1) out[b][a] += period[a];
  }
  /// \copydoc gather
  void gather(std::vector<double> const& x, int cell, double (*out)[d], bool periods = true) const {
    with_kind([&](auto kind) { gather(kind, x, cell, out, periods); });
  }
  /// The edges of a point of a cell, as columns.
  template <class Kind>
  static Matrix<double, d, d> edges(Kind, double const (*at)[d], int point) {
    Matrix<double, d, d> a;
    for (int k = 0; k < d; ++k) {
      auto const [low, up] = Kind::ends(point, k);
      for (int i = 0; i < d; ++i) a(i, k) = at[up][i] - at[low][i];
    }
    return a;
  }
  /// \copydoc edges
  Matrix<double, d, d> edges(double const (*at)[d], int point) const {
    return with_kind([&](auto kind) { return edges(kind, at, point); });
  }
  /// The deformation gradient at a point of a cell.
  template <class Kind>
  static Matrix<double, d, d> gradient(Kind kind, double const (*at)[d], int point, CellPoint<d> const& of) {
    return edges(kind, at, point) * of.inverse_edges;
  }
  /// \copydoc gradient
  Matrix<double, d, d> gradient(double const (*at)[d], int point, CellPoint<d> const& of) const {
    return edges(at, point) * of.inverse_edges;
  }
  /// Adds to the corners of a cell what the stress times \f$-A^{-T}\f$ does to them.
  template <class Kind>
  static void add_forces(Kind, Matrix<double, d, d> const& P, int point, CellPoint<d> const& of,
                         double (*f)[d]) {
    for (int k = 0; k < d; ++k) {
      auto const [low, up] = Kind::ends(point, k);
      for (int i = 0; i < d; ++i) {
        double pull = 0;
        for (int j = 0; j < d; ++j) pull += P(i, j) * of.inverse_edges(k, j);
        f[low][i] += pull, f[up][i] -= pull;
      }
    }
  }
  /// \copydoc add_forces
  void add_forces(Matrix<double, d, d> const& P, int point, CellPoint<d> const& of, double (*f)[d]) const {
    with_kind([&](auto kind) { add_forces(kind, P, point, of, f); });
  }
  /// Adds what the corners of a cell have to the nodes.
  template <class Kind>
  void scatter(Kind, double const (*f)[d], int cell, std::vector<double>& to) const {
    std::size_t const first = std::size_t(cell) * Kind::corners;
    for (int b = 0; b < Kind::corners; ++b)
      for (int a = 0; a < d; ++a) to[std::size_t(d) * nodes[first + b] + a] += f[b][a];
  }
  /// \copydoc scatter
  void scatter(double const (*f)[d], int cell, std::vector<double>& to) const {
    with_kind([&](auto kind) { scatter(kind, f, cell, to); });
  }
  /// How many cells there are.
  int cells() const { return static_cast<int>(points.size()) / points_per_cell; }
  /// A point of a cell.
  CellPoint<d> const& at(int cell, int point) const {
    return points[std::size_t(cell) * points_per_cell + point];
  }
  /// Memory, bytes.
  std::size_t bytes() const {
    return points.capacity() * sizeof(CellPoint<d>) + masses.capacity() * sizeof(double) +
           nodes.capacity() * sizeof(int) + wraps.capacity();
  }

  int corners;                       ///< of a cell
  bool simplex;                      ///< whether a cell has one point
  int points_per_cell;               ///< 1, or as many as corners
  std::vector<CellPoint<d>> points;  ///< of the first cell, of the second, ...
  std::vector<double> masses;        ///< of the nodes
  std::vector<int> nodes;            ///< at the corners of the first cell, of the second, ...

 private:
  std::vector<unsigned char> wraps;
  Place period{};

  void shifts(BodyMesh const& mesh) {
    for (int a = 0; a < d; ++a) period[a] = mesh.periods[a];
    nodes.reserve(mesh.cells.size() * corners);
    for (auto const& cell : mesh.cells) nodes.insert(nodes.end(), cell.begin(), cell.begin() + corners);
    if (mesh.wraps.empty()) return;
    wraps.reserve(nodes.size());
    for (auto const& cell : mesh.wraps) wraps.insert(wraps.end(), cell.begin(), cell.begin() + corners);
  }
  void add(BodyMesh const& mesh, int cell, detail::HatQuadrature const& hats, StoredEnergy<d> const& medium,
           std::function<double(Place const&)> const& density) {
    double X[most_corners][d];
    for (int b = 0; b < corners; ++b) {
      auto const place = corner_place(mesh, cell, b);
      for (int a = 0; a < d; ++a) X[b][a] = place[a];
    }
    // The means of the density, and of what it makes of the energy, under each hat function and in all.
    std::array<double, 8> mass{}, weight{};
    double all_weight = 0;
    for (auto const& s : hats.samples) {
      Place at{};
      for (int b = 0; b < corners; ++b)
        for (int a = 0; a < d; ++a) at[a] += s.hat[b] * X[b][a];
      double const rho = density(at);
      if (!is_finite(rho)) throw NotFinite("density in " + mesh.cell_name(cell));
      if (!(rho >= 0))
        throw OutsideDomain("density in " + mesh.cell_name(cell), "a density of mass is not negative", rho,
                            0);
      double const w = medium.weight(rho);
      for (int b = 0; b < corners; ++b) {
        mass[b] += s.weight * s.hat[b] / hats.total[b] * rho;
        weight[b] += s.weight * s.hat[b] / hats.total[b] * w;
      }
      all_weight += s.weight / hats.all * w;
    }
    double const parts = simplex ? (d == 1 ? 1 : d == 2 ? 2 : 6) : corners;
    for (int p = 0; p < points_per_cell; ++p) {
      auto const A = edges(X, p);
      double const det = small_determinant(A);
      if (!(det > 0))
        throw InvertedCell(mesh.cell_name(cell) + ", corner " + std::to_string(p),
                           "its edges have the orientation of the body; their determinant", det, 0);
      double const volume = det / parts;
      points.push_back({inverse_matrix(A), volume, volume * (simplex ? all_weight : weight[p])});
      for (int b = 0; b < corners; ++b) {
        double const share = simplex ? volume / corners : b == p ? volume : 0;
        if (share > 0 && !(mass[b] > 0))
          throw OutsideDomain("density in " + mesh.cell_name(cell), "a cell has mass", mass[b], 0);
        masses[mesh.cells[cell][b]] += share * mass[b];
      }
    }
  }
};

}  // namespace actio
