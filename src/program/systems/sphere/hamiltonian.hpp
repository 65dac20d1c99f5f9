// The Hamiltonian of a flow on the sphere: which stream function a vorticity has.
//
// Euler's fluid has a fixed depth, and Laplacian psi = vorticity. In a quasi-geostrophic layer the depth may
// change a little, and (Laplacian - gamma) psi = potential vorticity, gamma being the square of the radius of
// the sphere over that of deformation (helmholtz_stream.hpp). In an averaged flow the vorticity that is
// carried has a smooth stream function (averaged_stream.hpp). Energy, waves and what a rotation of the sphere
// does follow from the stream function.
#pragma once

#include "actio/quantized_sphere/averaged_stream.hpp"
#include "actio/quantized_sphere/matrix_harmonics.hpp"
#include "program/registry/system.hpp"

namespace actio::scene {

/// Euler's, that of a layer, or that of averaged flow.
struct SphereHamiltonian {
  double gamma = 0;   ///< what is subtracted from the Laplacian, 0 but for a layer
  double length = 0;  ///< alpha of averaged flow, in radii of the sphere, 0 for others
  sphere::AveragedMetric metric = sphere::AveragedMetric::deformation;  ///< of averaged flow

  /// Whether the vorticity is the Laplacian of the stream function.
  bool euler() const { return !layer() && !averaged(); }
  /// Whether it is that of a layer.
  bool layer() const { return gamma > 0; }
  /// Whether it is that of averaged flow.
  bool averaged() const { return length > 0; }
  /// By what a coefficient of the vorticity is divided for that of minus psi: with \f$y=l(l+1)\f$ it is
  /// \f$y+\gamma\f$, in averaged flow \f$y(1+\alpha^2(y-2))\f$ or, with the rough metric,
  /// \f$y(1+\alpha^2y)\f$.
  double divisor(int l) const {
    double const y = l * (l + 1.0);
    return averaged() ? y * (1 + length * length * (y - sphere::metric_shift(metric))) : y + gamma;
  }
  /// By what rate about the pole the free flow is turned back on a sphere that rotates,
  /// \f$2\Omega/(2+\gamma)\f$ for a layer, \f$\Omega/(1+2\alpha^2)\f$ with the rough metric: its own rotation
  /// for the others.
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
  Key<double> averaging = key(
      "averaging", number.called("a number, 0 or more").in("radii of the sphere"), LeftOut{"no averaging"},
      "The length alpha of the averaged equations of Euler: the vorticity q is carried by a velocity that "
      "is smooth on this length, q = (1 - alpha^2 (Laplacian + 2)) Laplacian psi. The vorticity of a scene "
      "is q, in [initial], rows and snapshots; flows that are given by a velocity have that velocity.",
      "0.1");
  Key<std::string> metric = key(
      "metric", one_of("metric", {"deformation", "rough"}), LeftOut{"\"deformation\", with averaging"},
      "The kinetic energy of averaged flow: deformation, that of 1/2 |u|^2 + alpha^2 |Def u|^2 with the rate "
      "of deformation Def u, which a rotation of all has not; or rough, that of 1/2 |u|^2 + alpha^2/2 |curl "
      "u|^2, with q = (1 - alpha^2 Laplacian) Laplacian psi.",
      "\"rough\"");
};
inline HamiltonianKeys const hamiltonian_keys{{"system"}};  ///< its keys

/// Reads it; `system.hamiltonian`, and `system.metric` of averaged flow, are written back where they are left
/// out.
/// @throws SceneError  where a layer has no radius of deformation, or one that is none, or Euler's fluid has
///                     one; where a length of averaging is none, a layer has one, or a metric has no length
SphereHamiltonian read_hamiltonian(SceneFile const& file);

}  // namespace actio::scene
