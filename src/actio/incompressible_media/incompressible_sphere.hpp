// An incompressible fluid on the unit sphere: the volume constraint (8.1) with a curved target (chapter 10C
// of the book).
//
//     IncompressibleSphere air(sphere_mesh(16), [](auto const& x) { return std::array{-x[1], x[0], 0.0}; },
//     0.01); air.step(100);
//     air.angular_momentum();   // all three to rounding
//
// Particles are unit vectors in space, their kinetic energy is that of the chords of their ways, and the area
// of each cell of great circles is kept. Rotations act on all of this exactly. In a turning frame nothing
// changes: the atmosphere turns with the planet as it begins to.
#pragma once

#include "actio/incompressible_media/incompressible_motion.hpp"

namespace actio::media {

/// The unit sphere in quadrilaterals: the six faces of a cube with n x n cells each, which see equal angles,
/// smoothed so that no line of the mesh has a kink at the edges of the cube.
/// @param cells  along an edge of the cube, at least two
/// @throws NotABodyMesh  where there are fewer
/// Accuracy: nodes on the sphere to rounding.
BodyMesh sphere_mesh(int cells);

/// An ideal fluid on the unit sphere, of density 1.
class IncompressibleSphere final : public IncompressibleMotion<SphereCell> {
 public:
  using Velocity = std::function<Place(Place const&)>;  ///< of a particle, by its place

  /// @param mesh      \ref sphere_mesh, or another one of quadrilaterals whose nodes are unit vectors
  /// @param velocity  at the start; what points out of the sphere or changes areas is taken from it
  /// @param step      the time step
  /// @throws NotABodyMesh, NotFinite, OutsideDomain  where these do not fit together
  IncompressibleSphere(BodyMesh mesh, Velocity const& velocity, double step,
                       VolumeSolving const& solving = {});

  /// The mesh of the particles.
  BodyMesh const& mesh() const { return *mesh_; }

 private:
  std::unique_ptr<BodyMesh> mesh_;
  IncompressibleSphere(std::unique_ptr<BodyMesh> mesh, Velocity const& velocity, double step,
                       VolumeSolving const& solving);
  bool forces(std::vector<double> const&, double, std::vector<double>&) const override { return false; }
  void move(SharpPlaces const& from, double h, double t, std::vector<double>& v,
            SharpPlaces& to) const override;
  void tangent(std::vector<double> const& y, double t, std::vector<double>& v) const override;
  void take_weight(std::vector<double>&) const override {}
};

}  // namespace actio::media
