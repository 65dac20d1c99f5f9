// Meshes of round bodies: annulus, disc, shell and ball, of quadrilaterals and hexahedra.
//
// No cell is flattened anywhere. A disc is a rounded square of cells, the core, with layers of cells between
// its edges and the circle; a ball is a rounded cube with layers between its faces and the sphere; a shell is
// these layers alone. Within each of these blocks the map from a grid of cells to the body is smooth, so that
// its cells are parallelograms or parallelepipeds but for a part that falls with the square of their size.
#pragma once

#include <cmath>

#include "actio/meshes/body_mesh.hpp"

namespace actio::media {

namespace detail {

/// Layers of cells around a lattice of c cells along each edge of a square or a cube.
class LayersOnCube {
 public:
  /// @param with_core  whether the lattice is filled with cells; if not there are layers alone
  LayersOnCube(int d, std::array<int, 2> const& cells, bool with_core);

  /// The mesh.
  /// @param place  of a point u of the cube in a layer: a callable (u, t), t from 0 at the lattice or the
  ///               inner side to 1 at the outer side; within a core t is 0
  template <class Place>
  BodyMesh mesh(Place const& place) const {
    BodyMesh mesh;
    mesh.dimension = d_;
    mesh.shape = d_ == 2 ? BodyMesh::Shape::quadrilateral : BodyMesh::Shape::hexahedron;
    mesh.nodes.resize(first_of_layer(layers_) + on_surface_);
    for (int layer = 0; layer <= layers_; ++layer)
      for_lattice(grid_.nodes(0), [&](std::array<int, 3> const& at) {
        if (surface_[grid_.node(at)] < 0 && !(core_ && layer == 0)) return;
        std::array<double, 3> u{};
        for (int k = 0; k < d_; ++k) u[k] = 2.0 * at[k] / grid_.cells[k] - 1;
        mesh.nodes[node(at, layer)] = place(u, double(layer) / layers_);
      });
    if (core_)
      for_lattice(grid_.cells[0], [&](std::array<int, 3> const& at) { add_cell(mesh, at, -1, 0, 0); });
    for (int layer = 0; layer < layers_; ++layer)
      for (int k = 0; k < d_; ++k)
        for (int end = 0; end < 2; ++end)
          for_lattice(grid_.cells[0], [&](std::array<int, 3> const& at) {
            if (at[k] == 0) add_cell(mesh, at, k, end, layer);
          });
    return mesh;
  }

 private:
  int d_, layers_;
  bool core_;
  CellGrid grid_;
  std::vector<int> surface_;  // the number of each point of the lattice on its surface, or -1
  int on_surface_ = 0;        // how many have one

  // Calls f for each point of a lattice with so many along each direction.
  template <class F>
  void for_lattice(int count, F const& f) const {
    for (int k = 0; k < (d_ > 2 ? count : 1); ++k)
      for (int j = 0; j < count; ++j)
        for (int i = 0; i < count; ++i) f(std::array<int, 3>{i, j, k});
  }
  // A core brings the nodes of layer 0, all of the lattice.
  int first_of_layer(int layer) const {
    return core_ ? int(surface_.size()) + (layer - 1) * on_surface_ : layer * on_surface_;
  }
  int node(std::array<int, 3> const& at, int layer) const {
    if (core_ && layer == 0) return grid_.node(at);
    return first_of_layer(layer) + surface_[grid_.node(at)];
  }
  // A cell of the core (k = -1), or of a layer on the side `end` of the lattice across k. In a layer
  // direction k keeps its sense, outwards on the upper side and inwards on the lower one: so every cell is
  // oriented as the lattice is.
  void add_cell(BodyMesh& mesh, std::array<int, 3> const& at, int k, int end, int layer) const;
};

/// A disc or a ball.
BodyMesh filled_mesh(char const* what, int d, double radius, std::array<int, 2> const& cells);

}  // namespace detail

/// An annulus about the origin, closed around: sides inner and outer.
/// @param inner, outer  radii, length, 0 < inner < outer
/// @param cells         how many across, from inner to outer, and how many around, at least three
/// @throws NotABodyMesh  where radii or cells are none; NotFinite
/// Accuracy: nodes on their circles to rounding.
BodyMesh annulus_mesh(double inner, double outer, std::array<int, 2> const& cells);

/// A disc about the origin: side outer.
/// @param radius  length
/// @param cells   how many across, from the core to the circle, and how many along an edge of the core, a
///                square of half the diameter; twice as many along as across make cells of one size
/// @throws NotABodyMesh  where the radius or cells are none; NotFinite
/// Accuracy: nodes of the side on their circle to rounding.
inline BodyMesh disc_mesh(double radius, std::array<int, 2> const& cells) {
  return detail::filled_mesh("disc", 2, radius, cells);
}

/// A ball about the origin: side outer.
/// @param radius  length
/// @param cells   how many across, from the core to the sphere, and how many along an edge of the core, a
///                cube
/// @throws NotABodyMesh  where the radius or cells are none; NotFinite
/// Accuracy: nodes of the side on their sphere to rounding.
inline BodyMesh ball_mesh(double radius, std::array<int, 2> const& cells) {
  return detail::filled_mesh("ball", 3, radius, cells);
}

/// A spherical shell about the origin: sides inner and outer. Its cells see a quarter of a great circle under
/// the same angle each.
/// @param inner, outer  radii, length, 0 < inner < outer
/// @param cells         how many across, from inner to outer, and how many along a quarter of a great circle
/// @throws NotABodyMesh  where radii or cells are none; NotFinite
/// Accuracy: nodes on their spheres to rounding.
BodyMesh shell_mesh(double inner, double outer, std::array<int, 2> const& cells);

}  // namespace actio::media
