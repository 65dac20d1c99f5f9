// summary.json: what a run took, what was skipped, and how far conserved quantities have drifted.
#include <nlohmann/json.hpp>

#include "actio/scene/run.hpp"

namespace actio::scene {

std::string summary_json(Scene const& scene, RunReport const& report, Drift const& drift) {
  using Json = nlohmann::ordered_json;
  Json out;
  out["title"] = scene.title;
  out["system"] = scene.system->name;
  out["status"] = report.ending == Ending::done ? "done" : report.ending == Ending::interrupted ? "interrupted" : "failed";
  if (!report.message.empty()) out["message"] = report.message;
  out["steps"] = report.steps;
  // Where a file failed, rows that were computed last may not be in it.
  if (report.ending != Ending::file_failed) out["rows"] = report.rows;
  out["wall_seconds"] = report.seconds;
  out["evaluations"] = Json::object();
  out["skipped"] = Json::array();
  for (auto const& count : scene.simulation.quantities.counts()) {
    out["evaluations"][count.name] = count.evaluations;
    if (!scene.simulation.quantities.needed(count.name)) out["skipped"].push_back(count.name);
  }
  out["shortcuts"] = scene.simulation.shortcuts;
  out["remarks"] = scene.simulation.remarks;
  out["drift"] = Json::object();
  for (auto const& entry : drift.entries()) out["drift"][entry.name] = entry.relative;
  out["actio"] = ACTIO_VERSION;
  return out.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace actio::scene
