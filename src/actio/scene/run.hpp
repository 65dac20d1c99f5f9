// A scene on its way: steps and rows, checkpoints and progress, until the end or until something stops it.
#pragma once

#include "actio/scene/drift.hpp"
#include "actio/scene/scene.hpp"
#include "actio/scene/series.hpp"

namespace actio::scene {

/// How a run ended: the exit status of the command.
enum class Ending { done = 0, scene_wrong = 2, numerics_failed = 3, file_failed = 4, interrupted = 130 };

/// What is to be done with a run besides the scene.
struct RunOptions {
  bool quiet = false;
  double checkpoint_interval = 2;  ///< seconds
};

/// How a run went.
struct RunReport {
  Ending ending = Ending::done;
  std::string message;  ///< where it did not end well: what went wrong
  long steps = 0;       ///< of the whole run, those before a resumption included
  long rows = 0;
  double seconds = 0;   ///< of this process
};

/// Runs a scene into a folder that is there and empty, or goes on from the checkpoint in it. Every row that was computed is in the files when it returns, whatever the ending.
RunReport run_scene(Scene& scene, std::string const& folder, bool resume, RunOptions const& options = {});

/// The largest relative drift of each conserved quantity that was asked for, ... the report of a run, as JSON.
std::string summary_json(Scene const& scene, RunReport const& report, Drift const& drift);

}  // namespace actio::scene
