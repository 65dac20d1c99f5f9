// The volumes of all cells of a mesh, their derivatives, and what these do to nodes and to cells: the
// constraints of an incompressible medium (chapter 10C of the book).
#pragma once

#include "actio/incompressible_media/cell_volume.hpp"
#include "actio/meshes/body_mesh.hpp"
#include "actio/parallel/row_share.hpp"

namespace actio::media {

/// Places of nodes as sums of two numbers: where cells are small, their volumes are not rounded as places
/// are.
struct SharpPlaces {
  std::vector<double> y;     ///< the nearest numbers, length
  std::vector<double> rest;  ///< what is to be added to them; empty: nothing
};

/// The volumes of the cells of a mesh as functions of the places of its nodes.
///
/// Velocities and forces, as places, are lists with `Cell::space` numbers a node; slopes, the derivatives G
/// of all volumes, have as many for each corner of each cell. Lists are of the whole mesh, of which some
/// cells are gone through.
/// @tparam Cell  what the cells are: \ref PlaneCell, \ref SpaceCell or \ref SphereCell
template <class Cell>
class MeshVolumes {
 public:
  static constexpr int N = Cell::space;          ///< components of a place
  static constexpr int corners = Cell::corners;  ///< of a cell

  /// @throws NotABodyMesh  where the cells of the mesh are of another kind
  explicit MeshVolumes(BodyMesh const& mesh) {
    if (mesh.dimension != Cell::body || is_simplex(mesh.shape))
      throw NotABodyMesh(
          "incompressible medium",
          "its cells have two ends along each direction: quadrilaterals in the plane, hexahedra "
          "in space, since triangles and tetrahedra with one pressure each lock; corners",
          corner_count(mesh.shape), corners);
    for (auto const& cell : mesh.cells) nodes_.insert(nodes_.end(), cell.begin(), cell.begin() + corners);
    for (auto const& wrap : mesh.wraps) wraps_.insert(wraps_.end(), wrap.begin(), wrap.begin() + corners);
    for (int a = 0; a < N; ++a) period_[a] = mesh.periods[a];
  }

  /// How many cells there are.
  std::size_t cells() const { return nodes_.size() / corners; }
  /// The node at a corner of a cell.
  int node(std::size_t cell, int corner) const { return nodes_[cell * corners + corner]; }
  /// The places of the corners of a cell, those across a seam moved by their period.
  void gather(std::vector<double> const& y, std::size_t cell, double (*out)[N]) const {
    for (int b = 0; b < corners; ++b)
      for (int a = 0; a < N; ++a) out[b][a] = y[std::size_t(N) * node(cell, b) + a];
    if (wraps_.empty()) return;
    for (int b = 0; b < corners; ++b)
      for (int a = 0; a < N; ++a)
        if (wraps_[cell * corners + b] >> a & 1) out[b][a] += period_[a];
  }
  /// The same, sharply: in flat space relative to the first corner.
  void gather(SharpPlaces const& places, std::size_t cell, double (*out)[N]) const {
    gather(places.y, cell, out);
    if constexpr (Cell::flat) {
      double const first[3] = {out[0][0], out[0][1], out[0][N - 1]};
      for (int b = 0; b < corners; ++b)
        for (int a = 0; a < N; ++a) out[b][a] -= first[a];
      if (places.rest.empty()) return;
      std::size_t const from = std::size_t(N) * node(cell, 0);
      for (int b = 1; b < corners; ++b)
        for (int a = 0; a < N; ++a)
          out[b][a] += places.rest[std::size_t(N) * node(cell, b) + a] - places.rest[from + a];
    }
  }
  /// The numbers of all cells.
  Ranges all() const { return {{0, static_cast<int>(cells())}}; }
  /// The volumes of cells.
  void volumes(SharpPlaces const& y, std::vector<double>& out, Ranges const& of) const {
    out.resize(cells());
    double at[corners][N];
    for_each(of, [&](std::size_t cell) { gather(y, cell, at), out[cell] = Cell::volume(at); });
  }
  /// The slopes of their volumes.
  void slopes(SharpPlaces const& y, std::vector<double>& out, Ranges const& of) const {
    out.resize(nodes_.size() * N);
    double at[corners][N], slope[corners][N];
    for_each(of, [&](std::size_t cell) {
      gather(y, cell, at), Cell::volume(at, slope);
      std::copy_n(&slope[0][0], corners * N, out.data() + cell * corners * N);
    });
  }
  /// The least Jacobian at the corners of cells.
  double least_jacobian(std::vector<double> const& y, Ranges const& of) const {
    double least = HUGE_VAL, at[corners][N];
    for_each(of, [&](std::size_t cell) {
      gather(y, cell, at);
      for (int b = 0; b < corners; ++b)
        if (double const J = Cell::corner(at, b); !(J >= least)) least = J;
    });
    return least;
  }
  /// The Jacobians at all corners, cell by cell.
  std::vector<double> corner_jacobians(std::vector<double> const& y) const {
    std::vector<double> out;
    out.reserve(nodes_.size());
    double at[corners][N];
    for (std::size_t cell = 0; cell < cells(); ++cell) {
      gather(y, cell, at);
      for (int b = 0; b < corners; ++b) out.push_back(Cell::corner(at, b));
    }
    return out;
  }
  /// f += scale G^T P: what pressures in the cells do to the nodes.
  void push(std::vector<double> const& slopes, std::vector<double> const& pressure, double scale,
            std::vector<double>& f, Ranges const& of) const {
    for_each(of, [&](std::size_t cell) {
      double const p = scale * pressure[cell];
      double const* slope = slopes.data() + cell * corners * N;
      for (int b = 0; b < corners; ++b)
        for (int a = 0; a < N; ++a) f[std::size_t(N) * node(cell, b) + a] += p * slope[b * N + a];
    });
  }
  /// G u: how fast the volumes change when the nodes have these velocities.
  void rates(std::vector<double> const& slopes, std::vector<double> const& u, std::vector<double>& out,
             Ranges const& of) const {
    out.resize(cells());
    for_each(of, [&](std::size_t cell) {
      double const* slope = slopes.data() + cell * corners * N;
      double sum = 0;
      for (int b = 0; b < corners; ++b)
        for (int a = 0; a < N; ++a) sum += slope[b * N + a] * u[std::size_t(N) * node(cell, b) + a];
      out[cell] = sum;
    });
  }
  /// The masses of the nodes: \f$m_v=\tfrac1n\sum_K\rho_K\,\partial A_K/\partial y_v\cdot(y_v-c_K)\f$ with
  /// the mean \f$c_K\f$ of the corners, such that a pressure which is linear in space moves a node by minus
  /// its gradient. In a parallelogram each corner has its share.
  /// @param y        places at which the medium has this density
  /// @param density  of each cell
  std::vector<double> masses(SharpPlaces const& y, std::vector<double> const& density) const {
    std::vector<double> out(y.y.size() / N, 0);
    double at[corners][N], slope[corners][N];
    for (std::size_t cell = 0; cell < cells(); ++cell) {
      gather(y, cell, at);
      double const volume = Cell::volume(at, slope);
      double share[corners], sum = 0;
      for (int b = 0; b < corners; ++b) {
        share[b] = 0;
        for (int a = 0; a < N; ++a) share[b] += slope[b][a] * (at[b][a] - mean(at, a));
        sum += share[b];
      }
      for (int b = 0; b < corners; ++b) out[node(cell, b)] += density[cell] * volume * share[b] / sum;
    }
    return out;
  }
  /// A component of the mean of corners.
  static double mean(double const (*at)[N], int a) {
    double sum = 0;
    for (int b = 0; b < corners; ++b) sum += at[b][a];
    return sum / corners;
  }
  /// Memory, bytes.
  std::size_t bytes() const { return nodes_.capacity() * sizeof(int) + wraps_.capacity(); }

 private:
  std::vector<int> nodes_;
  std::vector<unsigned char> wraps_;
  std::array<double, 3> period_{};
};

}  // namespace actio::media
