#include "program/registry/scene.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <limits>

#include "actio/numbers/nearest_name.hpp"
#include "program/registry/accuracy.hpp"
#include "program/registry/common_keys.hpp"
#include "program/registry/keys.hpp"
#include "program/registry/units.hpp"

namespace actio::scene {
namespace {

System const& system_of(SceneFile const& file) {
  KindKeys const keys{{"system"}, systems().front().name};
  SceneTable const table = file.section("system");
  if (!table.has("kind"))
    for (auto const& key : table.keys())
      if (std::string const meant = did_you_mean(key, {"kind"}); !meant.empty())
        table.fail(key, "unknown key of [system] '" + shown(key) + "'" + meant);
  return *find_system(keys.kind.read(table));
}

/// Whether the format is one of snapshots alone.
bool is_of_snapshots(std::string const& format, System const& system) {
  if (!system.snapshots) return false;
  auto const& formats = system.snapshots->formats;
  return std::any_of(formats.begin(), formats.end(), [&](auto const& known) { return known.name == format; });
}

std::string why_between_steps(Schedule const& schedule, double step) {
  double const meets = schedule.step_up_to(step);
  return fmt::format(
      "run.between_steps: {}, so that a shorter step of the same scheme goes to each "
      "row between two steps of {:.6g}",
      meets > 0 ? fmt::format("a step that all times of {} are multiples of is {:.6g}",
                              schedule.has_others() ? "rows and snapshots" : "rows", meets)
                : "the times of the rows have no divisor in common",
      step);
}

/// What the system makes of the scene. What it does not place itself is wrong with the whole of it.
Simulation prepared(System const& system, Request const& request, Schedule& schedule, Pilots const& pilots) {
  try {
    bool const step_given = request.file.section("method").has("step");
    auto const chosen = choose_steps(system, request, pilots);
    Simulation simulation = system.prepare(request);
    bool const beside = !simulation.exact && !step_given && !schedule.met_by(simulation.step);
    bool const refused = request.file.section("run").has("between_steps") && !schedule.between_steps();
    if (beside && refused && schedule.common_divisor() > 0) {
      request.file.section("method").set("step", schedule.step_up_to(simulation.step));
      simulation = system.prepare(request);
    } else if (beside && !schedule.between_steps()) {
      schedule.allow_between_steps();
      request.file.section("run").set("between_steps", true);
      simulation.remarks.push_back(why_between_steps(schedule, simulation.step));
    }
    // refuses a step that does not meet the rows
    if (!simulation.exact) StepsToRows(request.schedule, simulation.step, request.file.section("method"));
    if (chosen) simulation.remarks.push_back(chosen->in_words(simulation));
    return simulation;
  } catch (SceneError const&) {
    throw;
  } catch (NumericsError const&) {
    throw;
  } catch (FileError const&) {
    throw;
  } catch (Stopped const&) {
    throw;
  } catch (Error const& error) {
    throw SceneError(request.file.section("system").place(), error.what());
  }
}

/// What [output] asks of snapshots, and when; nothing where it does not.
std::optional<SnapshotRequest> snapshots_of(SceneTable const& output, System const& system,
                                            std::vector<std::string> const& formats) {
  if (!system.snapshots) return {};
  if (!output.has("snapshots")) {
    std::string const needs = "[output] snapshots, the list of what they hold, is needed with it; [] for " +
                              system.snapshots->always + " alone";
    for (char const* key : {"snapshot_at", "snapshot_every"})
      if (output.has(key)) output.fail(key, std::string(key) + ": " + needs);
    for (std::size_t i = 0; i < formats.size(); ++i)
      if (is_of_snapshots(formats[i], system))
        throw SceneError(output.place("formats", i),
                         "formats: " + formats[i] + " is for snapshots: " + needs);
    return {};
  }
  return SnapshotRequest{SnapshotKeys{{"output"}, *system.snapshots}.snapshots.read(output), formats};
}

/// When there are snapshots.
Schedule snapshot_times(SceneTable const& output, Schedule const& rows) {
  Schedule const schedule(output, rows);
  if (schedule.rows() > most_snapshots) {
    auto const& [every, at] = std::tie(snapshot_times_keys.every, snapshot_times_keys.at);
    (every.given(output) ? AnyKey(every) : AnyKey(at))
        .fail(output, fmt::format("at most {} snapshots are possible, and these are {}", most_snapshots,
                                  schedule.rows()));
  }
  return schedule;
}

}  // namespace

Scene Scene::read(SceneFile file, Pilots const& pilots) {
  file.allow({"scene", "system", "initial", "method", "run", "output"});
  System const& system = system_of(file);
  allow_keys(file, system);
  refuse_words_of_other_systems(file, system);
  read_units(file);
  SceneTable output = file.section("output");
  std::string const title =
      scene_keys.title.read_or(file, printable(std::filesystem::path(file.name()).stem().string()));
  long const seed = scene_keys.seed.read(file);

  Schedule schedule(file.section("run"));

  auto known = names_of(system.quantities);
  if (system.own_quantities)
    for (auto const& own : system.own_quantities(file)) known.push_back(own.name);
  OutputKeys const keys{{"output"}, system, known};
  auto const quantities = keys.quantities.read(file), formats = keys.formats.read(file);
  auto const snapshots = snapshots_of(output, system, formats);
  std::optional<Schedule> times;
  if (snapshots) schedule.meet(times.emplace(snapshot_times(output, schedule)));
  bool const plots = keys.plots.read(file);
  // An accuracy is compared with the error.
  auto wanted = keys.error_estimate.find(file);
  bool const by_accuracy = accuracy_keys.accuracy.given(file);
  if (!wanted && by_accuracy) wanted = true;
  Simulation simulation = prepared(system, {file, schedule, quantities, wanted, snapshots}, schedule, pilots);
  if (times && schedule.between_steps()) times->allow_between_steps();
  if (!keys.error_estimate.given(file))
    keys.error_estimate.write(file, simulation.companion.motion != nullptr);
  return {file,
          &system,
          title,
          seed,
          schedule,
          quantities,
          formats,
          plots,
          std::move(simulation),
          times,
          accuracy_keys.accuracy.find(file)};
}

}  // namespace actio::scene
