#include "program/document/scenes.hpp"

#include "program/base/embedded.hpp"
#include "program/document/file.hpp"

namespace actio::scene {

std::vector<NamedScene> const& carried_scenes() {
  static std::vector<NamedScene> const all = [] {
    std::vector<NamedScene> out;
    for (auto const& [name, text] : embedded::scenes()) {
      SceneFile const file = SceneFile::parse(text, std::string(name));
      out.push_back({std::string(name), file.section("scene").text("title"),
                     file.section("system").text("kind"), text});
    }
    return out;
  }();
  return all;
}

NamedScene const* find_scene(std::string const& name) {
  for (auto const& scene : carried_scenes())
    if (scene.name == name) return &scene;
  return nullptr;
}

}  // namespace actio::scene
