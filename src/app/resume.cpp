#include "app/commands.hpp"

#include "actio/scene/scene_error.hpp"

namespace actio::app {

int resume(ResumeArguments const&) { throw scene::SceneError({"resume"}, "not built yet"); }

}  // namespace actio::app
