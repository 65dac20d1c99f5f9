// A scene on its way: steps and rows, checkpoints and progress, until the end or until something stops it.
//
// A run in a folder writes its first checkpoint before its first step, and another one every few seconds:
// killed at any moment, it can go on. What it leaves is then what it would have left, bit for bit.
#pragma once

#include <functional>

#include "program/base/interrupt.hpp"
#include "program/output/series.hpp"
#include "program/registry/error_estimate.hpp"
#include "program/registry/scene.hpp"
#include "program/run/drift.hpp"
#include "program/run/progression.hpp"

namespace actio::scene {

/// How a run ended: the exit status of the command.
enum class Ending {
  done = 0,             ///< all rows are there
  scene_wrong = 2,      ///< the scene is wrong
  numerics_failed = 3,  ///< a step too long for its scheme, no convergence
  file_failed = 4,      ///< the disk is full, a file is not there or not permitted
  interrupted = 130     ///< stopped before its end
};

/// What is to be done with a run besides the scene.
struct RunOptions {
  bool quiet = false;  ///< nothing on standard error
  /// files are on the disk at each checkpoint, the first before the first step; otherwise for other programs
  /// to see alone
  bool durable = true;
  double checkpoint_interval = 2;            ///< seconds
  std::function<bool()> stop = interrupted;  ///< whether to end between two steps
  /// Told how far the run is, from 0 to 1, and its time: about a hundred times a second. May be empty.
  std::function<void(double fraction, double time)> watch = {};
  /// Of a run in memory: told of each snapshot when the motion is there; empty: there are none.
  std::function<void(double time)> snapshot = {};
};

/// How a run went.
struct RunReport {
  Ending ending = Ending::done;     ///< how it ended
  std::string message;              ///< where it did not end well: what went wrong
  long steps = 0;                   ///< of the whole run, those before a resumption included
  long rows = 0;                    ///< of the whole run, that of t = 0 included
  long snapshots = 0;               ///< of the whole run
  double seconds = 0;               ///< of all its processes
  std::vector<Drift::Entry> drift;  ///< of each conserved quantity
  /// of what the state has, attitude and momentum, estimated; none where that was not possible
  std::vector<ErrorEstimate::Entry> error;
  std::string error_how;  ///< in words: how it is estimated, or why it is not
  /// of the run where it is done, otherwise that this process wrote; the time first
  std::vector<double> last_row;
  StepChanges step_changes;  ///< of \ref with_other_step
  /// of the state at the end, or of the last row where there are no steps; empty where it did not end well
  std::string hash;
  std::string summary;       ///< as in summary.json
};

/// What the table of a run tells besides its numbers.
/// @param written  the scene, with every default
/// @param rows     expected; a matter of speed alone
SeriesHead series_head(Scene const& scene, std::string const& written, long rows);

/// The files that a run of the scene writes into its folder, pictures aside.
std::vector<std::string> files_of_run(Scene const& scene);

/// Refuses a scene that could take no step from its start, before anything is written.
/// @throws NumericsError
void refuse_without_step(Scene const& scene);

/// Runs a scene into a folder that is there, or goes on from the checkpoint in it. Every row that was
/// computed is in the files when it returns, whatever the ending. The caller has the folder for itself
/// (\ref RunFolder).
/// @throws FileError  where its files cannot be made, or those that are there are not those of the checkpoint
/// @throws SceneError  where a file that the scene was read with has changed
RunReport run_scene(Scene& scene, std::string const& folder, bool resume, RunOptions const& options = {});
/// Goes on from the checkpoint in the folder with steps of another length, which scene.toml says from then
/// on. The steps are at multiples of it: a shorter one leads from the state to the first of them.
/// @param before  the scene as it was, whose checkpoint is in the folder
/// @throws NumericsError  where the state can take no such step; all is then as it was, but for rows after
///                        the checkpoint
/// @throws SceneError     where a row lies within the shorter step
RunReport run_with_other_step(Scene& scene, Scene& before, std::string const& folder,
                              RunOptions const& options = {});

/// Runs a scene into a table in memory, row after row, the time first; leaves no file.
/// @throws TooLarge  where the memory does not suffice for the table (memory_series.hpp)
RunReport run_in_memory(Scene& scene, std::vector<double>& table, RunOptions const& options = {});

/// Whether the run in this folder has come to its end: all rows are in its checkpoint, how it ended is told,
/// and no file has failed.
/// @throws FileError  where the checkpoint cannot be read, is damaged, or belongs to another scene
bool run_is_finished(Scene const& scene, std::string const& folder);

/// The scene of the run in this folder, to a later time: its rows so far are then the first of a longer run.
/// Its scene.toml says so when this returns, and has said what it said before until then.
/// @throws SceneError  where the run goes that far already, has rows that a longer one would not have, or has
///                     no rows or steps that meet the time
/// @throws FileError   where the checkpoint cannot be read, is damaged, or belongs to another scene
Scene extended(Scene const& scene, std::string const& folder, double until);

/// The scene of the run in this folder with steps of another length.
/// @throws SceneError  where it has no steps, or rows are at no multiples of such
/// @throws NumericsError  where its start could take no such step
Scene with_other_step(Scene const& scene, std::string const& folder, double step);
/// Where `run_with_other_step` was killed between the checkpoint and scene.toml, which belong together, the
/// latter gets its name.
void finish_change_of_step(std::string const& folder);

/// Seconds between two checkpoints: what the environment variable ACTIO_CHECKPOINT_SECONDS says, otherwise
/// those of `RunOptions`.
/// @throws SceneError  where it is no number, or negative
double checkpoint_interval();

/// The report of a run, as JSON: how it ended, steps, rows, seconds, evaluations, what was skipped, the
/// largest drift of each conserved quantity in its unit, and the estimated error.
std::string summary_json(Scene const& scene, RunReport const& report);

}  // namespace actio::scene
