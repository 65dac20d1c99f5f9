// A scene that is changed after it was read, key by key and in order: for programs that hold it.
#include "program/document/document.hpp"
#include "program/document/file.hpp"

namespace actio::scene {
namespace {

/// Takes out of `from` what is at the end of `path`, a table for each name that leads to the key.
void take_out(toml::table& from, toml::table const& path) {
  for (auto const& [key, node] : path) {
    toml::node* const there = from.get(key.str());
    if (there && node.is_table() && there->is_table())
      take_out(*there->as_table(), *node.as_table());
    else if (there && !node.is_table())
      from.erase(key.str());
  }
}

}  // namespace

void SceneFile::change(std::string const& argument) { detail::apply_override(document_->root, argument); }
void SceneFile::drop(std::string const& key) {
  take_out(document_->root, detail::parse_toml(key + "=0", "key " + shown(key, 100)));
}

}  // namespace actio::scene
