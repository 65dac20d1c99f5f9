// The end of a scene, for tests.
#pragma once

#include <boost/test/unit_test.hpp>

#include "program/run/run.hpp"

namespace actio::scene {

/// The last row of a scene, without its time.
inline std::vector<double> last_row(SceneFile file) {
  Scene scene = Scene::read(std::move(file));
  std::vector<double> table;
  RunOptions options;
  options.quiet = true;
  auto const report = run_in_memory(scene, table, options);
  BOOST_REQUIRE_MESSAGE((report.ending == Ending::done), report.message);
  return {table.end() - static_cast<long>(scene.simulation.quantities.row_size()), table.end()};
}
/// The same of a scene that is written here.
inline std::vector<double> last_row(std::string const& text) {
  return last_row(SceneFile::parse(text, "scene.toml"));
}

}  // namespace actio::scene
