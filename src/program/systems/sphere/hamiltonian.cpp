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

SphereHamiltonian read_hamiltonian(SceneFile const& file) {
  auto const& [hamiltonian, deformation] =
      std::tie(hamiltonian_keys.hamiltonian, hamiltonian_keys.deformation);
  bool const deforms = deformation.given(file);
  if (hamiltonian.read_or(file, deforms ? "quasi_geostrophic" : "euler") == "euler") {
    if (deforms)
      deformation.fail(
          file, "Euler's fluid has no radius of deformation; hamiltonian = \"quasi_geostrophic\" has one");
    return {};
  }
  if (!deforms)
    hamiltonian.fail(
        file,
        "a quasi-geostrophic layer needs 'deformation', its radius of deformation in radii of the sphere");
  double const radius = deformation.read(file);
  if (!(radius >= least_deformation && radius <= most_deformation))
    deformation.fail(
        file, fmt::format("a radius from {} to {}, in radii of the sphere, is expected, found {}; beyond the "
                          "greatest the layer is Euler's fluid",
                          least_deformation, most_deformation, radius));
  return {1 / (radius * radius)};
}

}  // namespace actio::scene
