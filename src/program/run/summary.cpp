// summary.json: what a run took, what was skipped, how far conserved quantities have drifted, and how large
// its error is.
#include <nlohmann/json.hpp>

#include "program/base/ranks.hpp"
#include "program/run/run.hpp"

namespace actio::scene {

std::string summary_json(Scene const& scene, RunReport const& report) {
  using Json = nlohmann::ordered_json;
  Json out;
  out["title"] = scene.title;
  out["system"] = scene.system->name;
  out["status"] = report.ending == Ending::done          ? "done"
                  : report.ending == Ending::interrupted ? "interrupted"
                                                         : "failed";
  if (!report.message.empty()) out["message"] = report.message;
  out["steps"] = report.steps;
  for (auto const& change : report.step_changes)
    out["step_changes"].push_back({{"t", change.time}, {"before", change.before}, {"step", change.step}});
  // Where a file failed, rows that were computed last may not be in it.
  if (report.ending != Ending::file_failed) out["rows"] = report.rows;
  if (scene.snapshots) out["snapshots"] = report.snapshots;
  out["wall_seconds"] = report.seconds;
  if (!report.hash.empty()) out["hash"] = report.hash;
  if (on_several_ranks()) {
    int const ranks = shared_ranks()->size(), rows = scene.simulation.shared_rows;
    out["ranks"] = ranks;
    if (rows > 0) out["rows_per_rank"] = (rows + ranks - 1) / ranks;  // or one less
    out["seconds_in_copies"] = shared_ranks()->seconds_in_copies;
  }
  out["evaluations"] = Json::object();
  out["skipped"] = Json::array();
  for (auto const& count : scene.simulation.quantities.counts()) {
    out["evaluations"][count.name] = count.evaluations;
    if (!scene.simulation.quantities.needed(count.name)) out["skipped"].push_back(count.name);
  }
  out["shortcuts"] = scene.simulation.shortcuts;
  out["remarks"] = scene.simulation.remarks;
  out["drift"] = Json::object();
  out["drift_units"] = Json::object();
  for (auto const& entry : report.drift)
    out["drift"][entry.name] = entry.relative, out["drift_units"][entry.name] = entry.unit;
  out["error"] = Json::object();
  Json until = Json::object();
  for (auto const& entry : report.error) {
    if (entry.told())
      out["error"][entry.name] = entry.error;
    else
      out["error"][entry.name] = entry.said;
    if (entry.until >= 0) until[entry.name] = {{"time", entry.until}, {"error", entry.then}};
  }
  out["error"]["how"] = report.error_how;
  out["error_until"] = until;
  if (scene.accuracy) out["accuracy"] = *scene.accuracy;
  out["actio"] = ACTIO_VERSION;
  return out.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace actio::scene
