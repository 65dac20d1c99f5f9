// The rows of a scene, for tests.
#pragma once

#include <boost/test/unit_test.hpp>

#include "program/run/run.hpp"

namespace actio::scene {

/// All rows of a scene, each with its time first.
inline std::vector<std::vector<double>> rows_of(SceneFile file) {
  Scene scene = Scene::read(std::move(file));
  std::vector<double> table;
  auto const report = run_in_memory(scene, table, {.quiet = true});
  BOOST_REQUIRE_MESSAGE((report.ending == Ending::done), report.message);
  auto const length = static_cast<long>(scene.simulation.quantities.row_size()) + 1;
  std::vector<std::vector<double>> out;
  for (auto at = table.begin(); at != table.end(); at += length) out.emplace_back(at, at + length);
  return out;
}
/// The last row of a scene, without its time.
inline std::vector<double> last_row(SceneFile file) {
  auto const row = rows_of(std::move(file)).back();
  return {row.begin() + 1, row.end()};
}
/// The same of a scene that is written here.
inline std::vector<double> last_row(std::string const& text) {
  return last_row(SceneFile::parse(text, "scene.toml"));
}

}  // namespace actio::scene
