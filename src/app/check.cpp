#include "app/commands.hpp"

#include "actio/scene/scene_error.hpp"

namespace actio::app {

int check(std::vector<std::string> const&) { throw scene::SceneError({"check"}, "not built yet"); }

}  // namespace actio::app
