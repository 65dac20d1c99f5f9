#include "actio/scene/keys.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "actio/numbers/nearest_name.hpp"
#include "actio/scene/printable.hpp"

namespace actio::scene {
namespace {

/// The sections, in the order of a scene.
std::vector<std::string> const sections{"scene", "system", "initial", "method", "run", "output"};

std::string section_of(std::string const& key) { return key.substr(0, key.find('.')); }
std::string table_of(std::string const& key) { return key.substr(0, key.rfind('.')); }
std::string name_of(std::string const& key) { return key.substr(key.rfind('.') + 1); }

std::string in_quotes(std::string const& word) { return "\"" + word + "\""; }
bool is_number(std::string const& order) {
  return order.find_first_not_of("0123456789") == std::string::npos;
}
std::string order_in_toml(std::string const& order) { return is_number(order) ? order : in_quotes(order); }

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
       "checked, "
       "and written into the copy of the scene.",
       "", "1"},
      {"scene.units", "a table with mass, length and time",
       "those of the body of the library, otherwise none",
       "The names of the units in which the numbers of the scene are, for the axes of pictures, the viewer "
       "and series.h5; no number is changed. A body of the library has units of its own.",
       "", R"({ mass = "kg", length = "m", time = "s" })"},
      {"scene.units.mass", "a text", "none",
       "The unit of mass; with that of length it gives that of moments of inertia, and with that of time "
       "those of momentum and energy.",
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
       "the longest that divides the times of the rows and turns the body by at most 0.05 radians",
       "The time that a step takes. Rows are at multiples of it, or anywhere with run.between_steps; an "
       "exact "
       "method does not use it.",
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
       "false; true where the times of the rows have no divisor in common and no step is given",
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
       "The files of the table: csv is series.csv, a text with 17 significant digits; hdf5 is series.h5, a "
       "data set for each quantity with its unit, meaning and formula." +
           meaning_of_formats(system),
       "", "[\"csv\", \"hdf5\"]", formats_of(system)},
      {"output.plots", "true or false", "false",
       "Whether pictures are drawn when the run is done, and a page that plays the motion: plots/*.svg and "
       "plots/index.html.",
       "", "true"},
      {"output.error_estimate", "true or false", "true where it costs less than a third of the run",
       "Whether the error of attitude and momentum is estimated, for a method that is not exact, from a "
       "second "
       "motion with other steps.",
       "", "true"},
  };
  if (system.snapshots)
    for (auto& key : keys_of_snapshots(*system.snapshots)) keys.push_back(std::move(key));
  return keys;
}

bool is_same(Parameter const& a, Parameter const& b) {
  return a.key == b.key && a.expects == b.expects && a.fallback == b.fallback && a.meaning == b.meaning &&
         a.unit == b.unit && a.allowed == b.allowed;
}

bool is_one_of(std::string const& word, std::vector<std::string> const& words) {
  return std::find(words.begin(), words.end(), word) != words.end();
}

/// `heavy_top and rigid_body_n`: those among whose names the word is.
template <class Names>
std::string systems_with(std::string const& word, Names names) {
  std::string out;
  for (auto const& system : systems())
    if (is_one_of(word, names(system))) out += (out.empty() ? "" : " and ") + system.name;
  return out;
}

/// What there is to say of a key that the table of this system does not have: which system has it; nothing
/// where none has.
std::string of_others(System const& system, std::string const& table, std::string const& key) {
  auto const names = [&table](System const& other) { return keys_in(keys_of(other), table); };
  std::string const others = systems_with(key, names);
  return others.empty() ? ""
                        : fmt::format("; it is a key of {}, and {} takes {}", others, system.name,
                                      listed(names(system)));
}

/// `kind` of system.kind: the text, not what a number or a list would be refused with.
template <class Names>
void refuse_of_others(Place const& place, std::string const& word, std::string const& what,
                      System const& system, Names names) {
  if (is_one_of(word, names(system))) return;
  std::string const others = systems_with(word, names);
  if (!others.empty())
    throw SceneError(place, fmt::format("unknown {0} '{1}': it is a {0} of {2}, and {3} has {4}", what,
                                        shown(word), others, system.name, listed(names(system))));
}

}  // namespace

std::vector<Parameter> keys_of(System const& system) {
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
  for (auto const& own : system.parameters) {
    auto const there =
        std::find_if(all.begin(), all.end(), [&own](Parameter const& key) { return key.key == own.key; });
    if (there == all.end())
      all.push_back(own);
    else
      *there = own;
  }
  auto const rank = [](Parameter const& key) {
    return std::find(sections.begin(), sections.end(), section_of(key.key)) - sections.begin();
  };
  std::stable_sort(all.begin(), all.end(),
                   [&rank](Parameter const& a, Parameter const& b) { return rank(a) < rank(b); });
  return all;
}

std::vector<std::string> keys_in(std::vector<Parameter> const& keys, std::string const& table) {
  std::vector<std::string> out;
  for (auto const& key : keys)
    if (table_of(key.key) == table) out.push_back(name_of(key.key));
  return out;
}

std::vector<std::string> tables_of(std::vector<Parameter> const& keys) {
  std::vector<std::string> out;
  for (auto const& key : keys)
    if (std::string const table = table_of(key.key); std::find(out.begin(), out.end(), table) == out.end())
      out.push_back(table);
  return out;
}

std::vector<KeyOfSystems> all_keys() {
  std::vector<KeyOfSystems> out;
  for (auto const& system : systems())
    for (auto const& key : keys_of(system)) {
      auto const there = std::find_if(out.begin(), out.end(), [&key](KeyOfSystems const& known) {
        return is_same(known.parameter, key);
      });
      if (there != out.end())
        there->of.push_back(&system);
      else
        out.push_back({key, {&system}});
    }
  // Those of one name stand together, sections in the order of a scene.
  std::vector<std::string> names;
  for (auto const& section : sections)
    for (auto const& known : out)
      if (section_of(known.parameter.key) == section &&
          std::find(names.begin(), names.end(), known.parameter.key) == names.end())
        names.push_back(known.parameter.key);
  auto const rank = [&names](KeyOfSystems const& known) {
    return std::find(names.begin(), names.end(), known.parameter.key) - names.begin();
  };
  std::stable_sort(out.begin(), out.end(),
                   [&rank](auto const& a, auto const& b) { return rank(a) < rank(b); });
  return out;
}

void allow_keys(SceneFile const& file, System const& system) {
  auto const keys = keys_of(system);
  auto const tables = tables_of(keys);
  for (auto const& table : tables) {
    // The key that leads to a table within is allowed by its own record.
    file.section(table).allow(keys_in(keys, table),
                              [&](std::string const& key) { return of_others(system, table, key); });
  }
}

void refuse_words_of_other_systems(SceneFile const& file, System const& system) {
  SceneTable const method = file.section("method"), output = file.section("output");
  if (method.is_text("name"))
    refuse_of_others(method.place("name"), method.text("name"), "method", system, names_of_methods);
  if (!output.has("quantities")) return;
  auto const quantities = output.texts("quantities");
  for (std::size_t i = 0; i < quantities.size(); ++i)
    refuse_of_others(output.place("quantities", i), quantities[i], "quantity", system, names_of_quantities);
}

}  // namespace actio::scene
