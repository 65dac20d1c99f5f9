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

namespace {

/// Averaged flow, or Euler's where the scene has no length.
SphereHamiltonian read_averaging(SceneFile const& file) {
  auto const& [averaging, metric] = std::tie(hamiltonian_keys.averaging, hamiltonian_keys.metric);
  if (!averaging.given(file)) {
    if (metric.given(file))
      metric.fail(file, "it is the metric of averaged flow, whose length is 'averaging'; there is none");
    return {};
  }
  double const length = averaging.read(file);
  bool const deforms = metric.read_or(file, "deformation") == "deformation";
  double const most = deforms ? std::sqrt(0.5) : most_deformation;
  if (!(length >= 0))
    averaging.fail(file, fmt::format("a length in radii of the sphere is expected, found {}", length));
  if (!(length < most))
    averaging.fail(
        file, fmt::format("a length below {:.6g} is expected, in radii of the sphere, found {}{}", most,
                          length, deforms ? "; with metric = \"deformation\" its square is below 1/2" : ""));
  return {0, length, deforms ? sphere::AveragedMetric::deformation : sphere::AveragedMetric::rough};
}

}  // namespace

SphereHamiltonian read_hamiltonian(SceneFile const& file) {
  auto const& [hamiltonian, deformation] =
      std::tie(hamiltonian_keys.hamiltonian, hamiltonian_keys.deformation);
  bool const deforms = deformation.given(file);
  if (hamiltonian.read_or(file, deforms ? "quasi_geostrophic" : "euler") == "euler") {
    if (deforms)
      deformation.fail(
          file, "Euler's fluid has no radius of deformation; hamiltonian = \"quasi_geostrophic\" has one");
    return read_averaging(file);
  }
  char const* const no_layer = "a quasi-geostrophic layer is not averaged; Euler's fluid is";
  if (hamiltonian_keys.averaging.given(file)) hamiltonian_keys.averaging.fail(file, no_layer);
  if (hamiltonian_keys.metric.given(file)) hamiltonian_keys.metric.fail(file, no_layer);
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
