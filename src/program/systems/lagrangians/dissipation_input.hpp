// What a scene says of friction that keeps a structure: [system.dissipation] of a Lagrangian of one's own.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "actio/any_group/reduced_system.hpp"
#include "program/document/key.hpp"

namespace actio::scene {

/// Its keys.
struct DissipationKeys : KeyTable {
  Key<std::string> kind = key(
      "kind", one_of("kind", {"conformal", "orbit"}), needed,
      "\"conformal\" damps in proportion to the momentum: brackets and Casimirs decay at a known rate, and "
      "a quadratic Lagrangian runs along its free motion. \"orbit\" turns the momentum on its coadjoint "
      "orbit: Casimirs are conserved, and the energy falls.",
      "\"orbit\"");
  Key<double> rate = key(
      "rate", number.called("a number >= 0").in("1/time, or of the metric over energy"), needed,
      "The rate c: p' has the term -c p (conformal), or ad*_theta p with theta = c (ad*_v p)^sharp (orbit).",
      "0.01");
  AnyKey metric =
      key("metric", "a symmetric matrix, positive definite", LeftOut{"the identity"},
          "Of friction on the orbit: the metric on the algebra by which ad*_v p becomes a velocity.",
          "[[1, 0, 0], [0, 1, 0], [0, 0, 2]]");
};
/// its keys
inline DissipationKeys const dissipation_keys{{"system.dissipation", LeftOut{"none"},
                                               "Friction that keeps a structure.",
                                               "{ kind = \"orbit\", rate = 0.01 }"}};

/// The friction; none where the scene has none.
/// @param remarks  what is to be known of the method with it
/// @throws SceneError  where a rate is negative, a metric is none, the orbits are points, or the method does
///                     not take it
std::optional<systems::Dissipation> read_dissipation(SceneFile const& file,
                                                     systems::ReducedSystem const& system,
                                                     std::vector<std::string>& remarks);

}  // namespace actio::scene
