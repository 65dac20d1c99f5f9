// A run that is held in memory, as Python sees it: made by running a scene, or read back from its folder.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "program/run/run.hpp"

namespace actio::python {

/// Snapshots of a field.
struct MemorySnapshots {
  std::vector<double> times;                      ///< of each
  std::vector<scene::SnapshotArray> coordinates;  ///< the same for all of them
  std::vector<scene::SnapshotArray> fields;       ///< the numbers of all times, one after the other

  /// One more.
  void add(double time, std::vector<scene::SnapshotArray> one);
};

/// The table of a run, and what belongs to it. The rows lie one after the other in `table`.
struct MemoryRun {
  /// A quantity of the rows, its columns, and its unit in this scene.
  struct Group {
    scene::ColumnGroup group;  ///< the quantity and its columns
    std::string unit;          ///< `energy × h` of a body whose unit of time is known
  };
  std::vector<double> table;
  std::vector<std::string> columns;  ///< the time first
  std::vector<Group> groups;         ///< the columns after the time, quantity by quantity
  std::string time_unit;             ///< empty where the scene has units of its own
  std::string summary;               ///< JSON
  std::string scene;                 ///< with every default written out
  scene::InputFiles inputs;          ///< with which it was read
  bool with_snapshots = false;       ///< whether the scene asks for some
  MemorySnapshots snapshots;         ///< that were taken
  scene::RunReport report;           ///< how it went; of a run that was read back only that it is there
};

/// One of the keys that are set or taken out before a scene is read.
struct Change {
  std::string text;   ///< KEY=VALUE, or KEY
  bool drop = false;  ///< whether the key is taken out
};

/// What is looked at between steps.
struct Watch {
  std::function<bool()> stop;                             ///< whether to end
  std::function<void(double fraction, double time)> see;  ///< how far the run is
};

/// Runs a scene to its end, until it fails, or until it is told to stop: `report` says which.
/// @throws SceneError, NumericsError, FileError  where the scene cannot be run
/// @throws Error  where its table does not fit into the memory that is available
MemoryRun run_in_memory(scene::SceneFile file, std::vector<Change> const& changes, Watch watch);

/// The run that the command has left in a folder: every row that is there.
/// @throws SceneError  where there is no run in it
/// @throws FileError   where its files cannot be read, or are not those of its scene
MemoryRun load_run(std::string const& folder);

/// The snapshots that are in the folder of a run.
/// @throws SceneError, FileError  as \ref load_run; where one of them is not there
MemorySnapshots load_snapshots(std::string const& folder);

/// Writes what the command would leave, but no checkpoint, into a folder that is made, or is there and empty.
/// @param scene     with every default written out; it names the formats of the table
/// @param table     row after row
/// @param pictures  whether they are drawn, too
void save_run(std::string const& scene, std::span<double const> table, std::string const& summary,
              std::string const& folder, bool pictures);

}  // namespace actio::python
