// Media on any mesh, with loads: the plain road.
#pragma once

#include "actio/scene/systems/medium_loads.hpp"
#include "actio/scene/systems/medium_material.hpp"
#include "actio/scene/systems/medium_motion.hpp"

namespace actio::scene {

/// What the plain road steps.
template <int d>
struct MeshRoad {
  BodyMesh mesh;                       ///< of the body
  Material material;                   ///< of the body
  std::shared_ptr<MediumStart> start;  ///< how it begins
  MediumLoads<d> loads;                ///< what acts on it
  int order = 2;                       ///< of the steps: 2 or 4
  Conserve conserve = Conserve::form;  ///< what they keep
  ArtificialViscosity viscosity = {};  ///< what spreads shocks

  /// The longest step for which small motions about the start are stable, from above within a per cent.
  double longest_step() const;
  /// The motion from the start.
  std::unique_ptr<MediumMotion<d>> motion(double step) const;
};

}  // namespace actio::scene
