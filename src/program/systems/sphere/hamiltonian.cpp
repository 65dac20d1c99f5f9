#include "program/systems/sphere/hamiltonian.hpp"

#include <fmt/format.h>

namespace actio::scene {
namespace {

/// Beyond these gamma is no more than rounding beside the Laplacian, or the other way round.
constexpr double least_deformation = 1e-3, most_deformation = 1e3;

}  // namespace

sphere::SphereHarmonics SphereHamiltonian::vorticity_of(sphere::SphereHarmonics laplacian_of_psi) const {
  for (int l = 1; l < laplacian_of_psi.degrees(); ++l)
    laplacian_of_psi.coefficient.row(l) *= divisor(l) / (l * (l + 1.0));
  return laplacian_of_psi;
}
sphere::SphereHarmonics SphereHamiltonian::laplacian_of_psi(sphere::SphereHarmonics vorticity) const {
  for (int l = 1; l < vorticity.degrees(); ++l) vorticity.coefficient.row(l) *= l * (l + 1.0) / divisor(l);
  return vorticity;
}

SphereHamiltonian read_hamiltonian(SceneTable system) {
  bool const deforms = system.has("deformation");
  if (!system.has("hamiltonian"))
    system.set("hamiltonian", std::string(deforms ? "quasi_geostrophic" : "euler"));
  if (system.choice("hamiltonian", "Hamiltonian", {"euler", "quasi_geostrophic"}) == "euler") {
    if (deforms)
      system.fail("deformation",
                  "deformation: Euler's fluid has no radius of deformation; hamiltonian "
                  "= \"quasi_geostrophic\" has one");
    return {};
  }
  if (!deforms)
    system.fail("hamiltonian",
                "hamiltonian: a quasi-geostrophic layer needs 'deformation', its radius of "
                "deformation in radii of the sphere");
  double const radius = system.number("deformation");
  if (!(radius >= least_deformation && radius <= most_deformation))
    system.fail("deformation",
                fmt::format("deformation: a radius from {} to {}, in radii of the sphere, is expected, "
                            "found {}; beyond the greatest the layer is Euler's fluid",
                            least_deformation, most_deformation, radius));
  return {1 / (radius * radius)};
}

std::vector<Parameter> hamiltonian_parameters() {
  return {
      {"system.hamiltonian",
       "a text",
       "\"euler\"; \"quasi_geostrophic\" where there is a deformation",
       "Which stream function psi a vorticity has: euler, Laplacian psi = vorticity; quasi_geostrophic, "
       "(Laplacian - gamma) psi = potential vorticity with gamma = 1/deformation^2, in a layer whose depth "
       "may change a little. In a layer the vorticity of a scene is the potential one, in [initial], rows "
       "and snapshots; flows that are given by a velocity (zonal_jet, rossby_haurwitz_4, zonal_rate) have "
       "that velocity. A layer is stepped in double precision.",
       "",
       "\"euler\"",
       {"euler", "quasi_geostrophic"}},
      {"system.deformation", "a number from 0.001 to 1000", "needed with hamiltonian = \"quasi_geostrophic\"",
       "The radius of deformation (Rossby's) of a layer: beyond it vortices hardly feel each other.",
       "radii of the sphere", "0.3"},
  };
}

}  // namespace actio::scene
