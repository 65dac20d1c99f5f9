// A run that is held in memory, as Python sees it.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "actio/scene/run.hpp"

namespace actio::python {

/// The table of a run, and what belongs to it. The rows lie one after the other in `table`, which no one changes any more: arrays look into it.
struct MemoryRun {
  std::vector<double> table;
  std::vector<std::string> columns;        ///< the time first
  std::vector<scene::ColumnGroup> groups;  ///< the columns after the time, quantity by quantity
  std::string summary;                     ///< JSON
  std::string scene;                       ///< with every default written out

  std::size_t rows() const { return table.size() / columns.size(); }
};

/// Runs a scene to its end, or until `stop`, which is asked between steps, says so.
/// @throws SceneError, NumericsError, FileError
MemoryRun run_in_memory(scene::SceneFile file, std::function<bool()> stop);

}  // namespace actio::python
