// What the library refuses of a scene, told where it stands.
#pragma once

#include "actio/numbers/errors.hpp"
#include "program/document/file.hpp"

namespace actio::scene {

/// What refuses is told with the place of a key.
template <class Make>
auto refused_at(SceneTable const& table, std::string const& key, Make const& make) {
  try {
    return make();
  } catch (SceneError const&) {
    throw;
  } catch (Error const& error) {
    table.fail(key, key + ": " + error.what());
  }
}

}  // namespace actio::scene
