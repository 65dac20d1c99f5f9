// A scene, run to its end, and what is said of it.
#pragma once

#include "program/run/run.hpp"
#include "program/run/run_folder.hpp"

namespace actio::app {

/// Refuses a scene that several ranks cannot share, where there are several.
/// @throws SceneError
void refuse_on_ranks(scene::Scene const& scene);

/// Runs, or goes on; remarks and complaints go to standard error, a closing line to standard output.
/// @param before  the scene with the steps up to the checkpoint, where they had another length
/// @return the exit status
int run_to_end(scene::Scene& scene, scene::RunFolder const& folder, bool resume, bool quiet,
               scene::Scene* before = nullptr);

}  // namespace actio::app
