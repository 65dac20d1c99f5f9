#include "python/memory_run.hpp"

namespace actio::python {

using namespace scene;

MemoryRun run_in_memory(SceneFile file, std::function<bool()> stop) {
  Scene scene = Scene::read(std::move(file));
  MemoryRun out;
  RunOptions options;
  options.quiet = true, options.stop = std::move(stop);
  RunReport const report = scene::run_in_memory(scene, out.table, options);
  if (report.ending == Ending::numerics_failed) throw NumericsError(report.message);
  if (report.ending == Ending::file_failed) throw FileError(report.message);
  out.columns = {"t"};
  for (auto const& name : scene.simulation.quantities.columns()) out.columns.push_back(name);
  out.groups = scene.simulation.quantities.column_groups();
  out.summary = report.summary;
  out.scene = scene.file.written();
  return out;
}

}  // namespace actio::python
