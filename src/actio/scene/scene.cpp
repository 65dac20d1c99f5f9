#include "actio/scene/scene.hpp"

#include <algorithm>
#include <filesystem>
#include <limits>

#include "actio/numbers/nearest_name.hpp"
#include "actio/scene/keys.hpp"
#include "actio/scene/units.hpp"

namespace actio::scene {
namespace {

System const& system_of(SceneFile const& file) {
  std::vector<std::string> kinds;
  for (auto const& system : systems()) kinds.push_back(system.name);
  return *find_system(file.section("system").choice("kind", "system", kinds, "actio list systems"));
}

std::vector<std::string> names(std::vector<Quantity> const& quantities) {
  std::vector<std::string> out;
  for (auto const& q : quantities) out.push_back(q.name);
  return out;
}

/// What the system makes of the scene. What it does not place itself is wrong with the whole of it.
Simulation prepared(System const& system, Request const& request, Schedule& schedule) {
  try {
    bool const step_given = request.file.section("method").has("step");
    Simulation simulation = system.prepare(request);
    if (!simulation.exact && !step_given && !schedule.between_steps() && schedule.common_divisor() == 0) {
      schedule.allow_between_steps();
      request.file.section("run").set("between_steps", true);
      simulation.remarks.push_back(
          "run.between_steps: the times of the rows have no divisor in common, so that a shorter step of the "
          "same scheme goes to each row between two steps");
    }
    // refuses a step that does not meet the rows
    if (!simulation.exact) StepsToRows(request.schedule, simulation.step, request.file.section("method"));
    return simulation;
  } catch (SceneError const&) {
    throw;
  } catch (NumericsError const&) {
    throw;
  } catch (FileError const&) {
    throw;
  } catch (Error const& error) {
    throw SceneError(request.file.section("system").place(), error.what());
  }
}

}  // namespace

Scene Scene::read(SceneFile file) {
  file.allow({"scene", "system", "initial", "method", "run", "output"});
  System const& system = system_of(file);
  allow_keys(file, system);
  refuse_words_of_other_systems(file, system);
  read_units(file);
  SceneTable head = file.section("scene"), output = file.section("output");
  if (!head.has("title")) head.set("title", printable(std::filesystem::path(file.name()).stem().string()));
  if (!head.has("seed")) head.set("seed", 1L);
  std::string const title = head.text("title");
  long const seed = head.integer("seed", 0, std::numeric_limits<long>::max());

  Schedule schedule(file.section("run"));

  if (!output.has("formats")) output.set("formats", std::vector<std::string>{"csv"});
  if (!output.has("plots")) output.set("plots", false);
  auto known = names(system.quantities);
  if (system.own_quantities)
    for (auto const& own : names(system.own_quantities(file))) known.push_back(own);
  auto const quantities = output.choices("quantities", "quantity", known, "actio list quantities");
  auto const formats = output.choices("formats", "format", {"csv", "hdf5"});
  bool const plots = output.boolean("plots");

  bool const wanted = output.has("error_estimate"), estimate = wanted && output.boolean("error_estimate");
  Simulation simulation = prepared(
      system, {file, schedule, quantities, wanted ? std::optional(estimate) : std::nullopt}, schedule);
  if (!wanted) output.set("error_estimate", simulation.companion.motion != nullptr);
  return {file, &system, title, seed, schedule, quantities, formats, plots, std::move(simulation)};
}

}  // namespace actio::scene
