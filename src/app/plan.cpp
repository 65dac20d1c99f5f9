// actio run --dry-run: what a run of the scene would do, and what it would not.
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "actio/numbers/nearest_name.hpp"
#include "app/commands.hpp"
#include "app/estimate.hpp"
#include "app/text.hpp"
#include "program/base/memory.hpp"
#include "program/base/printable.hpp"
#include "program/base/progress.hpp"
#include "program/registry/scene.hpp"

namespace actio::app {

using namespace scene;

namespace {

constexpr std::size_t plan_width = 100, label = 12;

void tell(std::string const& name, std::string const& text) {
  fmt::print("{:<{}}{}\n", name, label, wrapped(text, plan_width, label));
}

std::string plural(long count, std::string const& one) {
  return fmt::format("{} {}{}", count, one, count == 1 ? "" : "s");
}

std::string method_of(Scene const& scene) {
  SceneTable const method = scene.file.section("method");
  std::string out = method.has("name") ? method.text("name") : "";
  if (method.has("order"))
    out += method.is_text("order") ? ", order \"" + method.text("order") + "\""
                                   : fmt::format(", order {}", method.integer("order", 0, 1000));
  return out;
}

std::string rows_of(Schedule const& schedule) {
  long const rows = schedule.rows();
  std::string out = plural(rows, "row") + fmt::format(", at t = {}", schedule.time(0));
  if (rows == 2) out += fmt::format(" and {}", schedule.time(1));
  if (rows > 2)
    out += fmt::format(", {}{}{}", schedule.time(1), rows == 3 ? ", " : ", ..., ", schedule.time(rows - 1));
  return out;
}

std::string steps_of(Scene const& scene) {
  if (scene.simulation.exact) return "none: each row is evaluated at its time";
  StepsToRows const steps(scene.schedule, scene.simulation.step, scene.file.section("method"));
  return plural(steps(scene.schedule.rows() - 1), "step") + fmt::format(" of {}", scene.simulation.step);
}

/// Which quantities are computed, and for what; which are not.
void tell_quantities(Scene const& scene) {
  std::vector<std::string> asked, needed, skipped;
  for (auto const& quantity : scene.simulation.quantities.counts()) {
    if (quantity.asked)
      asked.push_back(quantity.name);
    else if (scene.simulation.quantities.needed(quantity.name))
      needed.push_back(quantity.name);
    else
      skipped.push_back(quantity.name);
  }
  tell("computed", listed(asked));
  if (!needed.empty()) tell("needed", listed(needed) + " (for what is computed; in no column)");
  tell("skipped", skipped.empty() ? "nothing" : listed(skipped));
}

bool asks_for_hdf5(Scene const& scene) {
  return std::find(scene.formats.begin(), scene.formats.end(), "hdf5") != scene.formats.end();
}

std::string files_of(Scene const& scene, RunArguments const& arguments, Estimate const& taken) {
  std::vector<std::string> files;
  std::size_t const columns = 1 + scene.simulation.quantities.row_size();
  std::string const shape =
      plural(scene.schedule.rows(), "row") + " of " + plural(static_cast<long>(columns), "column");
  files.push_back(fmt::format("series.csv ({}, about {})", shape, size_text(taken.csv)));
  if (asks_for_hdf5(scene))
    files.push_back(fmt::format("series.h5 ({}, about {})", shape, size_text(taken.hdf5)));
  files.insert(files.end(), {"summary.json", "scene.toml", "checkpoint"});
  if (scene.snapshots)
    files.push_back("snapshots/ (" + plural(scene.snapshots->rows(), "snapshot") +
                    (taken.snapshots > 0 ? ", about " + size_text(taken.snapshots) : "") + ")");
  if (scene.plots || arguments.plots) files.push_back("plots/");
  return listed(files);
}

/// `about 3 s`, `less than a second`
std::string time_of(Estimate const& taken) {
  if (taken.seconds < 0) return "not known: the first step fails";
  return taken.seconds < 1
             ? "less than a second"
             : "about " + duration_text(taken.seconds) + ", by what the first steps and some rows take";
}

/// What is free where the folder is, or will be.
double free_space(std::string const& out) {
  std::error_code error;
  std::filesystem::path place = std::filesystem::absolute(out, error);
  while (!place.empty() && !std::filesystem::exists(place, error) && place != place.root_path())
    place = place.parent_path();
  auto const space = std::filesystem::space(place, error);
  return error ? -1 : static_cast<double>(space.available);
}

void tell_disk(Scene const& scene, Estimate const& taken, std::string const& out) {
  double const free = free_space(out);
  if (free < 0) return;
  // While a file is made anew the one that was there is there as well.
  double const needed = taken.snapshots + taken.csv + (asks_for_hdf5(scene) ? 2 * taken.hdf5 : 0);
  tell("disk", size_text(free) + " free");
  if (needed > free)
    tell("remark", fmt::format("the disk has room for {}, and the files take about {}: fewer rows "
                               "(run.every) or quantities{} take less, --out names another place",
                               size_text(free), size_text(needed),
                               taken.snapshots > 0 ? ", or fewer snapshots (output.snapshot_every)," : ""));
}

/// Ranks share what is stepped; what is looked at and written is all on rank 0.
void tell_memory(Scene const& scene, int ranks) {
  double const bytes = scene.simulation.bytes, shared = scene.simulation.shared_bytes,
               part = scene.simulation.part_bytes / ranks;
  if (ranks > 1 && !scene.simulation.on_ranks)
    throw SceneError({scene.file.name()}, "this scene is not shared among ranks; actio run takes it on one");
  if (!(bytes > 0)) return;
  if (ranks == 1) return tell("memory", "at most about " + size_text(bytes));
  tell("memory",
       fmt::format("at most about {} on rank 0, which has the whole state when rows are written, and {} on "
                   "each of the others, beside what MPI takes",
                   size_text(bytes - shared * (1 - 1.0 / ranks) + part),
                   size_text(bytes_of_program + scene.simulation.whole_bytes + shared / ranks + part)));
}

}  // namespace

int plan(Scene& scene, RunArguments const& arguments, std::string const& out) {
  fmt::print("{}\n", heading(printable(scene.title)));
  tell("system", scene.system->name + ": " + scene.system->title);
  tell("method", method_of(scene));
  tell("rows", rows_of(scene.schedule));
  tell("steps", steps_of(scene));
  tell_quantities(scene);
  for (auto const& shortcut : scene.simulation.shortcuts) tell("shortcut", shortcut);
  for (auto const& remark : scene.simulation.remarks) tell("remark", remark);
  Estimate const taken = estimate(scene);
  tell("time", time_of(taken));
  tell_memory(scene, arguments.ranks);
  tell("folder", out);
  tell("files", files_of(scene, arguments, taken));
  tell_disk(scene, taken, out);
  std::error_code none;
  if (std::filesystem::exists(out, none) && !std::filesystem::is_empty(out, none) && !arguments.force)
    tell("remark", "the folder is not empty; a run needs --force to replace what is in it");
  fmt::print("The scene is in order; nothing was run.\n");
  return 0;
}

}  // namespace actio::app
