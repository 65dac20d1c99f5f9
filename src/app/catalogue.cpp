#include "app/catalogue.hpp"

#include <algorithm>

#include "program/catalogue/bodies.hpp"
#include "program/catalogue/groups.hpp"
#include "program/catalogue/materials.hpp"
#include "program/catalogue/statements.hpp"
#include "program/document/scenes.hpp"
#include "program/registry/keys.hpp"

namespace actio::app {

using namespace scene;

std::vector<MethodOf> all_methods() {
  std::vector<MethodOf> out;
  for (auto const& system : systems())
    for (auto const& method : system.methods) out.push_back({&method, &system});
  return out;
}
std::vector<QuantityOf> all_quantities() {
  std::vector<QuantityOf> out;
  for (auto const& system : systems())
    for (auto const& quantity : system.quantities) out.push_back({&quantity, &system});
  return out;
}

std::vector<std::string> const& kinds_of_lists() {
  static std::vector<std::string> const kinds{"systems", "groups",    "methods", "quantities",
                                              "bodies",  "materials", "keys",    "scenes"};
  return kinds;
}

std::vector<std::string> names_in(std::string const& list) {
  std::vector<std::string> out;
  auto const add = [&](std::string const& name) {
    if (std::find(out.begin(), out.end(), name) == out.end()) out.push_back(name);
  };
  if (list == "systems")
    for (auto const& system : systems()) add(system.name);
  if (list == "groups")
    for (auto const& group : library_groups()) add(group.name);
  if (list == "methods")
    for (auto const& entry : all_methods()) add(entry.method->name);
  if (list == "quantities")
    for (auto const& entry : all_quantities()) add(entry.quantity->name);
  if (list == "bodies")
    for (auto const& body : library_bodies()) add(body.name);
  if (list == "materials")
    for (auto const& material : library_materials()) add(material.name);
  if (list == "keys")
    for (auto const& key : all_keys()) add(key.parameter.key);
  if (list == "scenes")
    for (auto const& carried : carried_scenes()) add(carried.name);
  return out;
}

std::vector<std::string> all_names() {
  std::vector<std::string> out;
  for (auto const& list : kinds_of_lists())
    for (auto const& name : names_in(list)) out.push_back(name);
  return out;
}

std::string names_of(std::vector<System const*> const& of) {
  if (of.size() == systems().size()) return "all";
  std::string out;
  for (auto const* const system : of) out += (out.empty() ? "" : ",") + system->name;
  return out;
}

std::string statement_in_words(std::string const& statement) {
  Statement const* const known = find_statement(statement);
  return known ? statement + ": " + known->subject : statement;
}

}  // namespace actio::app
