// actio list: tables with a line for each name, which comes first, so that they serve in a pipe.
#include <fmt/format.h>

#include <algorithm>

#include "actio/numbers/nearest_name.hpp"
#include "app/catalogue.hpp"
#include "app/commands.hpp"
#include "app/text.hpp"
#include "program/base/printable.hpp"
#include "program/base/progress.hpp"
#include "program/catalogue/bodies.hpp"
#include "program/catalogue/groups.hpp"
#include "program/catalogue/materials.hpp"
#include "program/document/scenes.hpp"
#include "program/registry/keys.hpp"
#include "program/registry/registry_json.hpp"

namespace actio::app {

using namespace scene;

namespace {

using Rows = std::vector<std::vector<std::string>>;

/// A row for each name and meaning: what several systems have alike is there once, with all of them in its
/// second cell.
void add(Rows& rows, std::vector<std::string> row) {
  for (auto& there : rows)
    if (there[0] == row[0] && std::equal(there.begin() + 2, there.end(), row.begin() + 2, row.end())) {
      there[1] += "," + row[1];
      return;
    }
  rows.push_back(std::move(row));
}

Rows list_of_systems() {
  Rows rows;
  for (auto const& system : systems()) rows.push_back({system.name, system.meaning});
  return rows;
}
Rows list_of_groups() {
  Rows rows;
  for (auto const& group : library_groups())
    rows.push_back({group.name, group.dimension, components_of(group), group.meaning});
  return rows;
}
Rows list_of_methods() {
  Rows rows;
  for (auto const& [method, system] : all_methods()) {
    std::string orders;
    for (auto const& order : method->orders) orders += (orders.empty() ? "" : ",") + order;
    add(rows, {method->name, system->name, orders, method->meaning});
  }
  return rows;
}
Rows list_of_quantities() {
  Rows rows;
  for (auto const& [quantity, system] : all_quantities())
    add(rows, {quantity->name, system->name, quantity->meaning});
  return rows;
}
Rows list_of_bodies() {
  Rows rows;
  for (auto const& body : library_bodies()) rows.push_back({body.name, body.title});
  return rows;
}

Rows list_of_materials() {
  Rows rows;
  for (auto const& material : library_materials()) {
    std::string constants;
    for (auto const& constant : material.constants)
      constants += (constants.empty() ? "" : ",") + constant.name;
    rows.push_back(
        {material.name, material.fluid ? "barotropic_fluid" : "elastic_body", constants, material.meaning});
  }
  return rows;
}

Rows list_of_keys() {
  Rows rows;
  // What differs between systems in its default or its words alone has one row.
  std::vector<KeyOfSystems> keys;
  for (auto const& key : all_keys()) {
    auto const alike = std::find_if(keys.begin(), keys.end(), [&](auto const& k) {
      return k.parameter.key == key.parameter.key && k.parameter.meaning == key.parameter.meaning;
    });
    if (alike == keys.end())
      keys.push_back(key);
    else
      alike->of.insert(alike->of.end(), key.of.begin(), key.of.end());
  }
  for (auto const& [parameter, of] : keys) rows.push_back({parameter.key, names_of(of), parameter.meaning});
  return rows;
}
Rows list_of_scenes() {
  Rows rows;
  for (auto const& carried : carried_scenes()) rows.push_back({carried.name, carried.system, carried.title});
  return rows;
}

/// How scenes take what is listed.
void say_how_scenes_take(std::string const& what) {
  if (what == "groups")
    say(stderr,
        "A scene takes one with its numbers, or a product: kind = \"euler_poincare\", group = \"SO(3) x "
        "R^1\"; actio show \"SE(2)\" shows its velocity.\n");
}

/// `bodies` for `body`: the one that begins alike, where none is nearest.
std::string meant(std::string const& what) {
  std::string const near = did_you_mean(what, kinds_of_lists());
  if (!near.empty() || what.size() < 3) return near;
  for (auto const& kind : kinds_of_lists())
    if (kind.starts_with(what.substr(0, 3))) return "; did you mean '" + kind + "'?";
  return "";
}

}  // namespace

int list(std::string const& what, bool json) {
  if (json && what != "systems" && what != "keys")
    throw SceneError({"actio list"}, "--json describes systems and keys alone: actio list systems --json");
  if (json) {
    fmt::print("{}", what == "keys" ? keys_json() : registry_json());
    return 0;
  }
  Rows rows;
  if (what == "systems")
    rows = list_of_systems();
  else if (what == "groups")
    rows = list_of_groups();
  else if (what == "methods")
    rows = list_of_methods();
  else if (what == "quantities")
    rows = list_of_quantities();
  else if (what == "bodies")
    rows = list_of_bodies();
  else if (what == "keys")
    rows = list_of_keys();
  else if (what == "scenes")
    rows = list_of_scenes();
  else if (what == "materials")
    rows = list_of_materials();
  else
    throw SceneError({"actio list"}, fmt::format("unknown list '{}'{} (known: {})", shown(what), meant(what),
                                                 listed(kinds_of_lists())));
  say_how_scenes_take(what);
  fmt::print("{}", aligned(rows));
  return 0;
}

}  // namespace actio::app
