#include "program/systems/lagrangians/shown.hpp"

#include <algorithm>

#include "actio/any_group/rigid_motions.hpp"

namespace actio::scene {
namespace {

using Shown = Quantity::Shown;

/// Frames are drawn in the plane and in space.
Shown of_configuration(systems::MatrixAlgebra const& algebra) {
  if ((algebra.size == 2 || algebra.size == 3) && systems::is_of_rotations(algebra))
    return Shown::as_rotation;
  if ((algebra.size == 3 || algebra.size == 4) && systems::is_of_rigid_motions(algebra))
    return Shown::as_motion;
  return Shown::by_curves;
}

/// A carried vector takes the momentum from its sphere. A sphere is drawn in space alone.
Shown of_momenta(ReducedScene const& scene) {
  auto const& algebra = scene.system->algebra;
  bool const sphere =
      algebra.dimension == 3 && scene.carried.empty() && systems::keeps_length_of_momenta(algebra);
  return sphere ? Shown::on_sphere : Shown::as_trajectory;
}

}  // namespace

void show_reduced(std::vector<Quantity>& quantities, ReducedScene const& scene) {
  Shown const configuration = of_configuration(scene.system->algebra), momenta = of_momenta(scene);
  for (auto& quantity : quantities) {
    bool const carried = std::ranges::any_of(
        scene.carried, [&](CarriedVector const& vector) { return vector.name == quantity.name; });
    if (quantity.name == "contact")
      quantity.shown = Shown::as_trajectory;
    else if (quantity.name == "body_momentum" || quantity.name == "spatial_momentum")
      quantity.shown = momenta;
    else if (quantity.name == "configuration")
      quantity.shown = configuration;
    else if (carried && configuration != Shown::by_curves)
      quantity.shown = Shown::beside_motion;
  }
}

}  // namespace actio::scene
