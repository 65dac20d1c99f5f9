#include "program/registry/registry_json.hpp"

#include <nlohmann/json.hpp>

#include "program/registry/keys.hpp"

namespace actio::scene {
namespace {

using Json = nlohmann::ordered_json;

/// What the columns of a quantity are called, where that does not depend on the scene; `...` stands for more.
Json columns_of(Quantity const& quantity) {
  using Kind = Quantity::Kind;
  if (quantity.kind == Kind::list) return {quantity.name + "_..."};
  Json out = Json::array();
  for (auto const& end : column_ends(quantity.kind)) out.push_back(quantity.name + end);
  if (quantity.kind == Kind::matrix || quantity.kind == Kind::skew) out.push_back("...");
  return out;
}

Json in_json(Parameter const& key) {
  return {{"key", key.key},         {"expects", key.expects}, {"fallback", key.fallback}, {"unit", key.unit},
          {"allowed", key.allowed}, {"meaning", key.meaning}, {"example", key.example}};
}

Json in_json(System const& system) {
  Json out{{"name", system.name},           {"title", system.title},       {"meaning", system.meaning},
           {"statement", system.statement}, {"parameters", Json::array()}, {"methods", Json::array()},
           {"quantities", Json::array()}};
  for (auto const& key : keys_of(system)) out["parameters"].push_back(in_json(key));
  for (auto const& m : system.methods)
    out["methods"].push_back(
        {{"name", m.name}, {"orders", m.orders}, {"meaning", m.meaning}, {"statement", m.statement}});
  for (auto const& q : system.quantities)
    out["quantities"].push_back({{"name", q.name},
                                 {"kind", kind_name(q.kind)},
                                 {"meaning", q.meaning},
                                 {"formula", q.formula},
                                 {"unit", q.unit},
                                 {"columns", columns_of(q)},
                                 {"statement", q.statement},
                                 {"needs", q.needs},
                                 {"conserved", q.conserved}});
  return out;
}

}  // namespace

std::string registry_json() {
  Json out = Json::array();
  for (auto const& system : systems()) out.push_back(in_json(system));
  return out.dump(1) + "\n";
}

std::string keys_json() {
  Json out = Json::array();
  for (auto const& [key, of] : all_keys()) {
    Json one = in_json(key);
    for (auto const* const system : of) one["systems"].push_back(system->name);
    out.push_back(one);
  }
  return out.dump(1) + "\n";
}

}  // namespace actio::scene
