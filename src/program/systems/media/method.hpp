// How a medium of a scene is stepped: `[method]`, and its step within what is stable.
#pragma once

#include <cmath>

#include "actio/media_on_meshes/body_start.hpp"
#include "program/registry/system.hpp"

namespace actio::scene {

/// The multisymplectic scheme with its orders.
std::vector<Method> medium_methods();

/// `[method]` without the step.
struct MediumMethod {
  int order = 2;                                     ///< of the steps: 2 or 4
  media::Conserve conserve = media::Conserve::form;  ///< what they keep
  media::ArtificialViscosity viscosity = {};         ///< what spreads shocks
  /// Whether steps are those of the optimised implementation.
  bool plain() const { return order == 2 && conserve == media::Conserve::form && !viscosity.any(); }
};
/// Reads it, and writes defaults back.
/// @throws SceneError  where a key is refused
MediumMethod read_medium_method(SceneFile const& file);

/// The part of the longest stable step that explicit steps may have: nearer to it waves of the size of a cell
/// grow by what is not linear in them.
inline constexpr double safe_part = 0.9;

/// The step of the scene, by default four tenths of the longest stable one, and short enough to follow loads.
/// @param longest      stable step, from above within a per cent
/// @param frequency    of loads that depend on time, 1/time
/// @param remarks      are told where a step that is given is too long for them
/// @param in_one       the longest that viscosity allows in one part
/// @param is_explicit  whether steps are, and so are safe up to a part of it
/// @throws NumericsError  where it is longer, with one that would do
double medium_step(Request const& request, double longest, double frequency,
                   std::vector<std::string>& remarks, double in_one = HUGE_VAL, bool is_explicit = true);

/// The records of the keys of [method] of a medium.
std::vector<Parameter> medium_method_parameters();

}  // namespace actio::scene
