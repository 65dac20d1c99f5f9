#include "app/commands.hpp"

#include "actio/scene/scene_error.hpp"

namespace actio::app {

int sweep(SweepArguments const&) { throw scene::SceneError({"sweep"}, "not built yet"); }

}  // namespace actio::app
