#include "app/run_to_end.hpp"

#include <fmt/format.h>

#include "app/draw.hpp"
#include "app/text.hpp"
#include "program/base/progress.hpp"
#include "program/base/ranks.hpp"

namespace actio::app {

using namespace scene;

namespace {

/// `apophis: 101 rows to t = 25 in 0.2 s; drift: energy 1.1e-16`
std::string closing_line(Scene const& scene, RunFolder const& folder, RunReport const& report) {
  std::string line = fmt::format("{}: {} rows to t = {} in {:.3g} s", folder.path(), report.rows,
                                 scene.schedule.time(scene.schedule.rows() - 1), report.seconds);
  for (std::size_t k = 0; k < report.drift.size(); ++k)
    line += fmt::format("{} {} {:.1e}", k == 0 ? "; drift:" : ",", report.drift[k].name,
                        report.drift[k].relative);
  std::string told, untold;
  for (auto const& entry : report.error)
    if (entry.told())
      told += fmt::format("{}{} {:.1e}{}", told.empty() ? "" : ", ", entry.name, entry.error, entry.unit);
    else
      untold += fmt::format("; error of {}: {}", entry.name, entry.said);
  if (!told.empty()) line += "; error: " + told + " (estimated)";
  line += untold;
  if (report.error.empty() && report.error_how.starts_with("not estimated"))
    line += "; error: " + report.error_how;
  return line;
}

/// Of a run whose steps have become too long: the state of its last checkpoint may take shorter ones.
std::string way_on(Scene const& scene, RunFolder const& folder, RunReport const& report) {
  if (report.ending != Ending::numerics_failed || scene.simulation.exact || !folder.begun()) return "";
  return fmt::format("; actio resume {} --step H goes on from the last checkpoint in shorter steps",
                     in_shell(folder.path()));
}

}  // namespace

void refuse_on_ranks(Scene const& scene) {
  if (on_several_ranks() && !scene.simulation.on_ranks)
    throw SceneError(
        {scene.file.name()},
        fmt::format(
            "this scene is not shared among {} ranks: gases and solids with explicit steps are, "
            "incompressible media on boxes, and flows on the sphere and the torus; actio run takes it "
            "on one",
            shared_ranks()->size()));
}

int run_to_end(Scene& scene, RunFolder const& folder, bool resume, bool quiet, Scene* before_change) {
  RunOptions options;
  options.quiet = quiet, options.checkpoint_interval = checkpoint_interval();
  auto const& remarks = scene.simulation.remarks;
  for (auto const& remark : remarks) say(stderr, remark + "\n");
  std::size_t const before = remarks.size();
  RunReport const report = before_change ? run_with_other_step(scene, *before_change, folder.path(), options)
                                         : run_scene(scene, folder.path(), resume, options);
  for (std::size_t k = before; k < remarks.size(); ++k) say(stderr, remarks[k] + "\n");
  if (report.ending == Ending::interrupted)
    say(stderr,
        fmt::format("{}; actio resume {} goes on from there\n", report.message, in_shell(folder.path())));
  else if (!report.message.empty())
    say(stderr, report.message + way_on(scene, folder, report) + "\n");
  else if (!quiet)
    say(stdout, closing_line(scene, folder, report) + "\n");
  if (scene.plots && (report.ending == Ending::done || report.ending == Ending::interrupted))
    draw(scene, folder.path(), quiet);
  return static_cast<int>(report.ending);
}

}  // namespace actio::app
