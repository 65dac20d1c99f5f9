// A scene to begin with: every key of a system, with what it means; those that are not needed are comments.
#pragma once

#include "program/catalogue/bodies.hpp"
#include "program/registry/system.hpp"

namespace actio::scene {

/// A scene of this system that runs as it is: that of its example, or with a body of the library, let go with
/// the spin of the catalogue for about six turns.
/// @param body  null for the example
/// @throws SceneError  where the system takes no body
std::string scene_template(System const& system, Body const* body = nullptr);

}  // namespace actio::scene
