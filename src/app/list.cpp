// actio list: tables with a line for each name, which comes first, so that they serve in a pipe.
#include <fmt/format.h>

#include "actio/scene/bodies.hpp"
#include "actio/scene/groups.hpp"
#include "actio/scene/nearest_name.hpp"
#include "actio/scene/printable.hpp"
#include "actio/scene/registry_json.hpp"
#include "app/catalogue.hpp"
#include "app/commands.hpp"
#include "app/text.hpp"

namespace actio::app {

using namespace scene;

namespace {

using Rows = std::vector<std::vector<std::string>>;

/// A row for each name and meaning: what several systems have alike is there once, with all of them in its second cell.
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
  for (auto const& group : library_groups()) rows.push_back({group.name, group.dimension, group.meaning});
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
  for (auto const& [quantity, system] : all_quantities()) add(rows, {quantity->name, system->name, quantity->meaning});
  return rows;
}
Rows list_of_bodies() {
  Rows rows;
  for (auto const& body : library_bodies()) rows.push_back({body.name, body.title});
  return rows;
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
  if (json && what != "systems") throw SceneError({"actio list"}, "--json tells of systems alone: actio list systems --json");
  if (json) {
    fmt::print("{}", registry_json());
    return 0;
  }
  Rows rows;
  if (what == "systems") rows = list_of_systems();
  else if (what == "groups") rows = list_of_groups();
  else if (what == "methods") rows = list_of_methods();
  else if (what == "quantities") rows = list_of_quantities();
  else if (what == "bodies") rows = list_of_bodies();
  else if (what == "materials") fmt::print(stderr, "There are no materials yet: they come with the systems of continua.\n");
  else throw SceneError({"actio list"}, fmt::format("unknown list '{}'{} (known: {})", shown(what), meant(what), listed(kinds_of_lists())));
  fmt::print("{}", aligned(rows));
  return 0;
}

}  // namespace actio::app
