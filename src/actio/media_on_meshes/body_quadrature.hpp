// Where a cell of a body's mesh has its stored energy: at each corner of box-like cells, once in simplices.
//
// At a corner of a box-like cell d edges meet. With A, their columns in the reference space, and a, those in
// space, \f$F = aA^{-1}\f$: no interpolation, and no motion of a cell is without energy. The corner stands
// for the part \f$\det A/2^d\f$ of the cell. Hexahedra that are no parallelepipeds have the correction of
// corner_correction.hpp. A simplex has one F, from the edges at its first corner.
//
// Where the density of mass varies, corners take their shares of it and of what it makes of the stored energy
// by the hat functions of the cell, such that their sum is the integral over the cell. A gas at rest between
// walls or against vacuum is then as heavy as its pressure is steep, up to the order of the scheme.
#pragma once

#include <functional>

#include "actio/meshes/body_mesh.hpp"
#include "actio/meshes/cell_geometry.hpp"
#include "actio/meshes/hat_quadrature.hpp"
#include "actio/stored_energy/stored_energies.hpp"

namespace actio::media {

/// One deformation gradient of a cell, and what it stands for.
template <int d>
struct CellPoint {
  Matrix<double, d, d> inverse_edges;  ///< \f$A^{-1}\f$, per length
  double volume;                       ///< its part of the reference volume
  double weight;                       ///< of W(F): the integral of the stored energy's weight over this part
};

/// Places, ways, velocities or forces at the corners of a cell.
template <int d>
struct CellCorners {
  double at[1 << d][d] = {};  ///< at each corner
  /// What they add to the deformation gradients at all points of the cell; of forces, the stress on that.
  Matrix<double, d, d> common = Matrix<double, d, d>::Zero();
};

/// What is known of cells when a program is compiled: simplices with one point, or boxes with one at each
/// corner.
template <int d, bool is_simplex>
struct CellKind {
  static constexpr int corners = is_simplex ? d + 1 : 1 << d;  ///< of a cell
  static constexpr int points = is_simplex ? 1 : 1 << d;       ///< of a cell
  static constexpr bool corrected = d == 3 && !is_simplex;     ///< whether corners may need a correction
  /// The corners at both ends of edge k of a point.
  static constexpr std::array<int, 2> ends(int point, int k) {
    if constexpr (is_simplex)
      return {0, k + 1};
    else
      return {point & ~(1 << k), point | (1 << k)};
  }
};

/// A density that is negative, or leaves a cell without mass.
struct NotADensity : OutsideDomain {
  /// As \ref OutsideDomain, with the cell; the bound is 0.
  NotADensity(std::string const& cell, std::string const& required, double was)
      : OutsideDomain("density in " + cell, required, was, 0) {}
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
  /// @throws NotFinite, NotADensity  where the density is no number, or is negative or a cell has no mass
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
  auto with_kind(F const& f) const { return simplex ? f(CellKind<d, true>{}) : f(CellKind<d, false>{}); }
  /// Where corners of a cell are, given the places of all nodes.
  /// @param periods  whether a corner beyond a seam is moved by its period: not for velocities
  template <class Kind>
  void gather(Kind, std::vector<double> const& x, int cell, CellCorners<d>& out, bool periods = true) const {
    std::size_t const first = std::size_t(cell) * Kind::corners;
    for (int b = 0; b < Kind::corners; ++b)
      std::copy_n(x.data() + std::size_t(d) * nodes[first + b], d, out.at[b]);
    if (periods && !wraps.empty())
      for (int b = 0; b < Kind::corners; ++b)
        for (int a = 0; a < d; ++a)
          if (wraps[first + b] >> a & 1) out.at[b][a] += period[a];
    if constexpr (Kind::corrected)
      if (!corrections.empty())
        out.common = corrections[cell].template common<double, d>([&](int b, int a) { return out.at[b][a]; });
  }
  /// \copydoc gather
  void gather(std::vector<double> const& x, int cell, CellCorners<d>& out, bool periods = true) const {
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
  static Matrix<double, d, d> gradient(Kind kind, CellCorners<d> const& here, int point,
                                       CellPoint<d> const& of) {
    Matrix<double, d, d> F = edges(kind, here.at, point) * of.inverse_edges;
    if constexpr (Kind::corrected) F += here.common;
    return F;
  }
  /// \copydoc gradient
  Matrix<double, d, d> gradient(CellCorners<d> const& here, int point, CellPoint<d> const& of) const {
    return with_kind([&](auto kind) { return gradient(kind, here, point, of); });
  }
  /// Adds to the corners of a cell what the stress times \f$-A^{-T}\f$ does to them.
  template <class Kind>
  static void add_forces(Kind, Matrix<double, d, d> const& P, int point, CellPoint<d> const& of,
                         CellCorners<d>& f) {
    for (int k = 0; k < d; ++k) {
      auto const [low, up] = Kind::ends(point, k);
      for (int i = 0; i < d; ++i) {
        double pull = 0;
        for (int j = 0; j < d; ++j) pull += P(i, j) * of.inverse_edges(k, j);
        f.at[low][i] += pull, f.at[up][i] -= pull;
      }
    }
    if constexpr (Kind::corrected) f.common += P;
  }
  /// \copydoc add_forces
  void add_forces(Matrix<double, d, d> const& P, int point, CellPoint<d> const& of, CellCorners<d>& f) const {
    with_kind([&](auto kind) { add_forces(kind, P, point, of, f); });
  }
  /// Adds what the corners of a cell have to the nodes.
  template <class Kind>
  void scatter(Kind, CellCorners<d>& f, int cell, std::vector<double>& to) const {
    if constexpr (Kind::corrected)
      if (!corrections.empty()) corrections[cell].add_forces(f.common, f.at);
    std::size_t const first = std::size_t(cell) * Kind::corners;
    for (int b = 0; b < Kind::corners; ++b)
      for (int a = 0; a < d; ++a) to[std::size_t(d) * nodes[first + b] + a] += f.at[b][a];
  }
  /// \copydoc scatter
  void scatter(CellCorners<d>& f, int cell, std::vector<double>& to) const {
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
           nodes.capacity() * sizeof(int) + wraps.capacity() +
           corrections.capacity() * sizeof(corrections[0]);
  }

  int corners;                       ///< of a cell
  bool simplex;                      ///< whether a cell has one point
  int points_per_cell;               ///< 1, or as many as corners
  std::vector<CellPoint<d>> points;  ///< of the first cell, of the second, ...
  std::vector<double> masses;        ///< of the nodes
  std::vector<int> nodes;            ///< at the corners of the first cell, of the second, ...
  std::vector<CornerCorrection<double, d>> corrections;  ///< of the cells; empty where none needs one

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
    std::size_t const first = points.size();
    add_points(mesh, cell, X);
    auto [mass, weight] = means(mesh, cell, X, hats, medium, density);
    share_out(mass, first), share_out(weight, first);
    for (int p = 0; p < points_per_cell; ++p)
      points[first + p].weight *= simplex ? weight.of_cell : weight.at_corner[p];
    for (int b = 0; b < corners; ++b) {
      if (!(mass.at_corner[b] > 0))
        throw NotADensity(mesh.cell_name(cell), "a cell has mass", mass.at_corner[b]);
      auto const& point = points[first + (simplex ? 0 : b)];
      masses[mesh.cells[cell][b]] += point.volume / (simplex ? corners : 1) * mass.at_corner[b];
    }
  }
  /// The points of a cell, with volumes in the place of weights.
  void add_points(BodyMesh const& mesh, int cell, double const (*X)[d]) {
    double ratio = 1;
    if constexpr (d == 3)
      if (!simplex) {
        Matrix<double, d, most_corners> places;
        for (int b = 0; b < most_corners; ++b)
          for (int a = 0; a < d; ++a) places(a, b) = X[b][a];
        auto const correction = corner_correction<double, d>(places);
        if (correction.any) corrections.reserve(mesh.cells.size()), corrections.resize(cell);
        if (correction.any || !corrections.empty()) corrections.push_back(correction);
        ratio = correction.ratio;
      }
    double const parts = simplex ? (d == 1 ? 1 : d == 2 ? 2 : 6) : corners;
    for (int p = 0; p < points_per_cell; ++p) {
      auto const A = edges(X, p);
      double const det = small_determinant(A);
      if (!(det > 0))
        throw InvertedCell(mesh.cell_name(cell) + ", corner " + std::to_string(p),
                           "its edges have the orientation of the body; their determinant", det, 0);
      double const volume = det / parts * ratio;
      points.push_back({inverse_matrix(A), volume, volume});
    }
    if (!(ratio > 0))
      throw InvertedCell(mesh.cell_name(cell), "a cell has a volume; over that of its corners", ratio, 0);
  }
  /// What varies over a cell: its means under the hat function of each corner, and that over the cell.
  struct Means {
    std::array<double, 8> at_corner{};
    double of_cell = 0;
  };
  /// Of the density, and of what it makes of the energy.
  std::pair<Means, Means> means(BodyMesh const& mesh, int cell, double const (*X)[d],
                                detail::HatQuadrature const& hats, StoredEnergy<d> const& medium,
                                std::function<double(Place const&)> const& density) const {
    std::pair<Means, Means> out;
    double volume = 0;
    for (auto const& s : hats.samples) {
      Place at{};
      Matrix<double, d, d> slope = Matrix<double, d, d>::Zero();
      for (int b = 0; b < corners; ++b)
        for (int a = 0; a < d; ++a) {
          at[a] += s.hat[b] * X[b][a];
          for (int i = 0; i < d; ++i) slope(a, i) += s.slope[b][i] * X[b][a];
        }
      double const rho = density(at);
      if (!is_finite(rho)) throw NotFinite("density in " + mesh.cell_name(cell));
      if (!(rho >= 0)) throw NotADensity(mesh.cell_name(cell), "a density of mass is not negative", rho);
      double const w = medium.weight(rho), part = s.weight * (simplex ? 1 : small_determinant(slope));
      for (int b = 0; b < corners; ++b) {
        out.first.at_corner[b] += s.weight * s.hat[b] / hats.total[b] * rho;
        out.second.at_corner[b] += s.weight * s.hat[b] / hats.total[b] * w;
      }
      out.first.of_cell += part * rho, out.second.of_cell += part * w, volume += part;
    }
    out.first.of_cell /= volume, out.second.of_cell /= volume;
    return out;
  }
  /// Makes the sum over the corners, with their volumes, the integral over the cell.
  void share_out(Means& means, std::size_t first) const {
    if (simplex) return;
    double sum = 0, volume = 0;
    for (int p = 0; p < points_per_cell; ++p)
      sum += points[first + p].volume * means.at_corner[p], volume += points[first + p].volume;
    for (int p = 0; p < points_per_cell; ++p)
      if (sum > 0) means.at_corner[p] *= means.of_cell * volume / sum;
  }
};

}  // namespace actio::media
