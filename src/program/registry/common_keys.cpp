#include "program/registry/common_keys.hpp"

#include <algorithm>

namespace actio::scene {
namespace {

std::string in_quotes(std::string const& word) { return "\"" + word + "\""; }
bool is_number(std::string const& order) {
  return order.find_first_not_of("0123456789") == std::string::npos;
}
std::string order_in_toml(std::string const& order) { return is_number(order) ? order : in_quotes(order); }

/// `"exact" for moser_veselov, 2 for natural_chart`, where `all` is false; otherwise every order of each.
std::string orders_of(System const& system, bool all) {
  std::string out;
  for (auto const& method : system.methods) {
    std::string orders;
    for (auto const& order : method.orders)
      if (all || orders.empty()) orders += (orders.empty() ? "" : ", ") + order_in_toml(order);
    out += (out.empty() ? ""
            : all       ? "; "
                        : ", ") +
           (all ? method.name + " takes " + orders : orders + " for " + method.name);
  }
  return out;
}

std::vector<Parameter> keys_of_scene() {
  return {
      {"scene.title", "a text", "the name of the file without its ending",
       "What the run is called in summary.json, series.h5, the pictures and the viewer.", "",
       "\"A body let go\""},
      {"scene.seed", "a whole number, 0 or more", "1",
       "Where random numbers begin: with another one a random start is another one (initial.random and "
       "initial.ring of vorticity_sphere). Where nothing is random it changes no number of a run; it is "
       "checked, and written into the copy of the scene.",
       "", "1"},
      {"scene.units", "a table with mass, length and time",
       "those of the body of the library, otherwise none",
       "The names of the units in which the numbers of the scene are, for the axes of pictures, the viewer "
       "and series.h5; no number is changed. A body of the library has units of its own.",
       "", R"({ mass = "kg", length = "m", time = "s" })"},
      {"scene.units.mass", "a text", "none",
       "The unit of mass; with that of length it gives that of moments of inertia, and with that of "
       "time those of momentum and energy.",
       "", "\"kg\""},
      {"scene.units.length", "a text", "none", "The unit of length.", "", "\"m\""},
      {"scene.units.time", "a text", "none", "The unit of time.", "", "\"s\""},
  };
}

std::vector<Parameter> keys_of_method(System const& system) {
  std::vector<std::string> orders;
  for (auto const& method : system.methods)
    for (auto const& order : method.orders)
      if (std::find(orders.begin(), orders.end(), order) == orders.end()) orders.push_back(order);
  return {
      {"method.name", "a text", in_quotes(system.methods.front().name),
       "The method that the system is stepped by (actio list methods).", "",
       in_quotes(system.methods.front().name), names_of_methods(system)},
      {"method.order", "a whole number, or a text", orders_of(system, false),
       "The order of the method: " + orders_of(system, true) + ".", "",
       order_in_toml(system.methods.front().orders.front()), orders},
      {"method.step", "a number > 0",
       "the longest that divides the times of the rows and turns the body by at most 0.05 radians; where "
       "that makes more than four times as many steps as needed, one that divides run.every, or run.until",
       "The time that a step takes. Rows are at multiples of it, or anywhere with run.between_steps; "
       "an exact method does not use it.",
       "time", "0.001"},
  };
}

std::vector<Parameter> keys_of_run() {
  return {
      {"run.until", "a number > 0", "needed; with run.at the last of its times",
       "The time at which the run ends; it begins at 0.", "time", "10"},
      {"run.every", "a number > 0", "or run.at; with neither, rows at 0 and at run.until",
       "The time from row to row: there are rows at its multiples, from 0 on, and at run.until.", "time",
       "0.1"},
      {"run.at", "a list of numbers, each greater than the one before, from 0 to run.until",
       "or run.every; with neither, rows at 0 and at run.until", "The times of the rows.", "time",
       "[0, 0.5, 2]"},
      {"run.between_steps", "true or false",
       "false; true where no step is given and the default step does not divide the times of the rows",
       "Whether rows may lie between two steps: one shorter step of the same scheme goes to each of these, "
       "for that row alone. It changes nothing where the method is exact.",
       "", "true"},
  };
}

std::vector<std::string> formats_of(System const& system) {
  std::vector<std::string> out{"csv", "hdf5"};
  if (system.snapshots)
    for (auto const& format : system.snapshots->formats) out.push_back(format.name);
  return out;
}

std::string meaning_of_formats(System const& system) {
  std::string out;
  if (system.snapshots && !system.snapshots->in_hdf5.empty())
    out = " For snapshots, hdf5: " + system.snapshots->in_hdf5 + ".";
  if (system.snapshots)
    for (auto const& format : system.snapshots->formats)
      out += " For snapshots, " + format.name + ": " + format.meaning + ".";
  return out;
}

/// Those of a system that has snapshots.
std::vector<Parameter> keys_of_snapshots(SnapshotKind const& kind) {
  std::vector<std::string> columns;
  std::string meaning, example;
  for (auto const& column : kind.columns) {
    columns.push_back(column.name);
    meaning += (meaning.empty() ? "" : "; ") + column.name + ": " + column.meaning;
    if (example.empty()) example = in_quotes(column.name);
  }
  return {
      {"output.snapshots", "a list of texts", "no snapshots",
       "What the files snapshots/000000.csv, 000001.csv, ... hold besides " + kind.always +
           ", which is what [] asks for; snapshots/times.csv tells their times. " + meaning + ".",
       "", "[" + example + "]", columns},
      {"output.snapshot_at", "a list of numbers, each greater than the one before, from 0 to run.until",
       "or output.snapshot_every; with neither, snapshots at 0 and at run.until",
       "The times of the snapshots.", "time", "[0.5, 1]"},
      {"output.snapshot_every", "a number > 0",
       "or output.snapshot_at; with neither, snapshots at 0 and at run.until",
       "The time from snapshot to snapshot: there are some at its multiples, from 0 on, and at run.until.",
       "time", "0.5"},
  };
}

std::vector<Parameter> keys_of_output(System const& system) {
  auto const quantities = names_of_quantities(system);
  std::vector<Parameter> keys{
      {"output.quantities", "a list of texts", "needed",
       "What the rows hold, in this order after the time; nothing else is computed (actio list quantities).",
       "", "[" + in_quotes(quantities.back()) + "]", quantities},
      {"output.formats", "a list of texts", "[\"csv\"]",
       "What there is for other programs besides the table series.csv, a text with 17 significant digits, "
       "which every run writes: hdf5 is series.h5, a data set for each quantity with its unit, meaning and "
       "formula. Such files are made of the plain ones, whole, when a run ends, once a minute while it goes "
       "on, and by actio export." +
           meaning_of_formats(system),
       "", "[\"csv\", \"hdf5\"]", formats_of(system)},
      {"output.plots", "true or false", "false",
       "Whether pictures are drawn when the run is done, and a page that plays the motion: "
       "plots/*.svg and plots/index.html.",
       "", "true"},
      {"output.error_estimate", "true or false", "true where it costs no more than half of the run",
       "Whether the error of attitude or configuration, momentum and carried vectors is estimated, for a "
       "method that is not exact, from two further motions with longer steps.",
       "", "true"},
  };
  if (system.snapshots)
    for (auto& key : keys_of_snapshots(*system.snapshots)) keys.push_back(std::move(key));
  return keys;
}

}  // namespace

std::vector<Parameter> common_keys(System const& system) {
  std::vector<Parameter> all;
  auto const add = [&all](std::vector<Parameter> const& keys) {
    all.insert(all.end(), keys.begin(), keys.end());
  };
  add(keys_of_scene());
  std::vector<std::string> kinds;
  for (auto const& other : systems()) kinds.push_back(other.name);
  all.push_back({"system.kind", "a text", "needed",
                 "The kind of system that is simulated (actio list systems).", "", in_quotes(system.name),
                 kinds});
  add(keys_of_method(system)), add(keys_of_run()), add(keys_of_output(system));
  return all;
}

std::vector<std::string> names_of_methods(System const& system) {
  std::vector<std::string> out;
  for (auto const& method : system.methods) out.push_back(method.name);
  return out;
}

std::vector<std::string> names_of_quantities(System const& system) {
  std::vector<std::string> out;
  for (auto const& quantity : system.quantities) out.push_back(quantity.name);
  return out;
}

}  // namespace actio::scene
