// The Hamiltonian of a flow on the sphere: which stream function a vorticity has.
//
// Euler's fluid has a fixed depth, and Laplacian psi = vorticity. In a quasi-geostrophic layer the depth may
// change a little, and (Laplacian - gamma) psi = potential vorticity, gamma being the square of the radius of
// the sphere over that of deformation (helmholtz_stream.hpp). Energy, waves and what a rotation of the sphere
// does follow from the stream function.
#pragma once

#include "actio/quantized_sphere/matrix_harmonics.hpp"
#include "program/registry/system.hpp"

namespace actio::scene {

/// Euler's, or that of a layer.
struct SphereHamiltonian {
  double gamma = 0;  ///< what is subtracted from the Laplacian, 0 for Euler's

  /// Whether it is that of a layer.
  bool layer() const { return gamma > 0; }
  /// \f$l(l+1)+\gamma\f$: by what a coefficient of the vorticity is divided for that of minus psi.
  double divisor(int l) const { return l * (l + 1.0) + gamma; }
  /// By what rate about the pole the free flow is turned back on a sphere that rotates,
  /// \f$2\Omega/(2+\gamma)\f$: its own rotation for Euler's.
  double frame_rate(double rotation) const { return 2 * rotation / divisor(1); }
  /// The vorticity that belongs to the velocity of a flow, from \f$\Delta\psi\f$.
  sphere::SphereHarmonics vorticity_of(sphere::SphereHarmonics laplacian_of_psi) const;
  /// And back: \f$\Delta\psi\f$.
  sphere::SphereHarmonics laplacian_of_psi(sphere::SphereHarmonics vorticity) const;
};

/// Which of them a scene has.
struct HamiltonianKeys : KeyTable {
  Key<std::string> hamiltonian = key(
      "hamiltonian", one_of("Hamiltonian", {"euler", "quasi_geostrophic"}),
      LeftOut{"\"euler\"; \"quasi_geostrophic\" where there is a deformation"},
      "Which stream function psi a vorticity has: euler, Laplacian psi = vorticity; quasi_geostrophic, "
      "(Laplacian - gamma) psi = potential vorticity with gamma = 1/deformation^2, in a layer whose depth "
      "may change a little. In a layer the vorticity of a scene is the potential one, in [initial], rows "
      "and snapshots; flows that are given by a velocity (zonal_jet, rossby_haurwitz_4, zonal_rate) have "
      "that velocity. A layer is stepped in double precision.",
      "\"euler\"");
  Key<double> deformation = key(
      "deformation", number.called("a number from 0.001 to 1000").in("radii of the sphere"),
      LeftOut{"needed with hamiltonian = \"quasi_geostrophic\""},
      "The radius of deformation (Rossby's) of a layer: beyond it vortices hardly feel each other.", "0.3");
};
inline HamiltonianKeys const hamiltonian_keys{{"system"}};  ///< its keys

/// Reads it; `system.hamiltonian` is written back where it is left out.
/// @throws SceneError  where a layer has no radius of deformation, or one that is none, or Euler's fluid has
///                     one
SphereHamiltonian read_hamiltonian(SceneFile const& file);

}  // namespace actio::scene
