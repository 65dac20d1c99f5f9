#include "app/commands.hpp"

#include "actio/scene/scene_error.hpp"

namespace actio::app {

int list(std::string const&) { throw scene::SceneError({"list"}, "not built yet"); }
int show(std::string const&) { throw scene::SceneError({"show"}, "not built yet"); }

}  // namespace actio::app
